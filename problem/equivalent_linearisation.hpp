#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// The Gaussian that equivalent linearisation gives for (z, z') under white noise of the same
/// intensity. Independent, zero-mean components.
struct EquivalentLinearisation {
  double damping;                 ///< c_eq
  double stiffness;               ///< k_eq
  double displacement_deviation;  ///< sigma_1 of paper (25)
  double velocity_deviation;      ///< sigma_2 of paper (26)
};

/// Solves, with D2 = lambda E[Y^2] / 2,
///
///     c_eq = c + (1-r) (2/pi) sigma_2 / sigma_1       (the impulsive damping term of paper (13))
///     k_eq = k + 3 mu sigma_1^2
///     sigma_2^2 = D2 / c_eq,   sigma_1 = sigma_2 / sqrt(k_eq).
EquivalentLinearisation equivalent_linearisation(const Problem& problem);

}  // namespace fpkcheck::problem
