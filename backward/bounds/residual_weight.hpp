#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Weight tau = 1 + (G / h0)^m of the residuals (docs/bounds.md) with the energy
///
///     G = (v + c y/2)^2/2 + (k - c^2/4) y^2/2 + mu y^4/4.
///
/// The energy G decreases along the flow (G' <= -c G), at impacts on a left wall at y <= 0 and at
/// impacts on a right wall at y >= 0. The bounds E[G^j] <= M_j and the scale h0 = (4 M_m)^(1/m)
/// give E[tau] <= 1.25.
struct ResidualWeight {
  double damping, stiffness, cubic;  ///< parameters c, k and mu of the oscillator
  int power;                         ///< exponent m of the weight tau
  double scale;                      ///< energy scale h0 of the weight tau
  double mean_bound;                 ///< upper bound of the mean E[tau] of the weight

  /// Values of the energy G and of the weight tau at (y, v), rounded to nearest
  double energy(double y, double v) const;
  double operator()(double y, double v) const;
};

/// Returns the reason why no bounds can be computed for a problem, in one line; empty if the
/// problem is supported.
std::string bounds_unsupported_reason(const problem::Problem& problem);

/// Returns upper bounds M_j of the moments E[G^j] of the energy G, j = 0 .. `power`.
/// @pre bounds_unsupported_reason(problem) is empty
std::vector<double> energy_moment_bounds(const problem::Problem& problem, int power);

/// Returns the weight tau with the exponent m = `power`.
/// @pre bounds_unsupported_reason(problem) is empty
ResidualWeight residual_weight(const problem::Problem& problem, int power);

}  // namespace fpkcheck::backward
