#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Weight tau = 1 + (G / h0)^m of the residuals (docs/bounds.md), with the Lyapunov function
///
///     G = (v + c y/2)^2/2 + (k - c^2/4) y^2/2 + mu y^4/4,
///
/// called the energy, of the oscillator with damping c and restoring force k y + mu y^3. The energy
/// function G decreases along the motion between impulses (G' <= -c G), at impacts on a left wall
/// at y <= 0 and at impacts on a right wall at y >= 0. The bounds M_j >= E[G^j] of the moments of
/// the energy G and the scale h0 = (4 M_m)^(1/m) give the bound E[tau] <= 1.25 of the mean weight.
struct ResidualWeightFunctionOfEnergy {
  double damping, stiffness, cubic_stiffness;  ///< parameters c, k and mu of the oscillator
  int exponent;                                ///< exponent m
  double energy_scale;                         ///< energy scale h0
  double mean_upper_bound;                     ///< upper bound of the mean E[tau]

  /// Returns the energy G at the state (y, v), in arithmetic rounded to nearest.
  double energy(double y, double v) const;
  /// Returns the weight tau of the residual at the state (y, v), in arithmetic rounded to nearest.
  double operator()(double y, double v) const;
};

/// Returns the reason why guaranteed bounds do not support a problem, in one line; empty if the
/// problem is supported.
std::string bounds_unsupported_reason(const problem::Problem& problem);

/// Returns upper bounds M_j of the moments E[G^j] of the energy G, for all j <= `highest_power`.
/// @pre bounds_unsupported_reason(problem) is empty
std::vector<double> energy_moment_bounds(const problem::Problem& problem, int highest_power);

/// Computes the weight tau = 1 + (G / h0)^m with the exponent m = `exponent`.
/// @pre bounds_unsupported_reason(problem) is empty
ResidualWeightFunctionOfEnergy make_residual_weight(const problem::Problem& problem, int exponent);

}  // namespace fpkcheck::backward
