#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Weight tau = 1 + (G / h0)^m of the residuals (docs/bounds.md), with the Lyapunov function
///
///     G = (v + c y/2)^2/2 + (k - c^2/4) y^2/2 + mu y^4/4,
///
/// which is called the energy. The energy G decreases along the motion between impulses (G' <= -c
/// G), at impacts on a left wall at y <= 0 and at impacts on a right wall at y >= 0. The bounds
/// E[G^j] <= M_j of the moments and the scale h0 = (4 M_m)^(1/m) give E[tau] <= 1.25.
struct ResidualWeightFunctionOfEnergy {
  double damping, stiffness, cubic_stiffness;  ///< parameters c, k and mu of the oscillator
  int exponent;                                ///< exponent m
  double energy_scale;                         ///< energy scale h0
  double mean_upper_bound;                     ///< upper bound of the mean E[tau]

  /// Returns the energy G at the state (y, v), rounded to nearest.
  double energy(double y, double v) const;
  /// Returns the weight tau at the state (y, v), rounded to nearest.
  double operator()(double y, double v) const;
};

/// Returns the reason why the bounds do not support a problem, in one line; empty if the problem is
/// supported.
std::string bounds_unsupported_reason(const problem::Problem& problem);

/// Returns upper bounds M_j of the moments E[G^j] of the energy G, for j = 0 .. `highest_power`.
/// @pre bounds_unsupported_reason(problem) is empty
std::vector<double> energy_moment_bounds(const problem::Problem& problem, int highest_power);

/// Computes the weight tau with the exponent m = `exponent`.
/// @pre bounds_unsupported_reason(problem) is empty
ResidualWeightFunctionOfEnergy make_residual_weight(const problem::Problem& problem, int exponent);

}  // namespace fpkcheck::backward
