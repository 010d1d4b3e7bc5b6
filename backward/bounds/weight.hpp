#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// The weight tau = 1 + (G / h0)^m by which residuals are judged, docs/bounds.md:
///
///     G = (v + c y/2)^2/2 + (k - c^2/4) y^2/2 + mu y^4/4,
///
/// which falls along the motion (G' <= -c G) and at impacts wherever walls stand, y <= 0 at the left
/// and y >= 0 at the right, with E[G^j] <= M_j and
/// h0 = (4 M_m)^(1/m), so that E[tau] <= 1.25.
struct Weight {
  double damping, stiffness, cubic;  ///< c, k, mu
  int power;                         ///< m
  double scale;                      ///< h0
  double mean_bound;                 ///< E[tau] is at most this

  /// G and tau, rounded.
  double energy(double y, double v) const;
  double operator()(double y, double v) const;
};

/// Why a problem has no such weight, or bounds could not use it, in one line; empty when it has one.
std::string weight_refused(const problem::Problem& problem);

/// Upper bounds M_0 .. M_power of E[G^j].
/// @pre weight_refused(problem) is empty
std::vector<double> energy_moment_bounds(const problem::Problem& problem, int power);

/// @pre weight_refused(problem) is empty
Weight weight(const problem::Problem& problem, int power);

}  // namespace fpkcheck::backward
