#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Equivalent linearisation: the Gaussian density of (z, z') under white noise of the same
/// intensity, with independent components of mean zero.
struct EquivalentLinearisation {
  double damping;                     ///< c_eq
  double stiffness;                   ///< k_eq
  double displacement_deviation = 0;  ///< sigma_1 of paper (25)
  double velocity_deviation = 0;      ///< sigma_2 of paper (26)
};

/// Solves, with D2 = lambda E[Y^2] / 2,
///
///     c_eq = c + (1-r) (2/pi) sigma_2 / sigma_1       (the impulsive damping term of paper (13))
///     k_eq = E[g'(|z|)] = k + 3 mu sigma_1^2
///     sigma_2^2 = D2 / c_eq,   sigma_1 = sigma_2 / sqrt(k_eq).
EquivalentLinearisation equivalent_linearisation(const Problem& problem);

/// Decay rate of the slowest mode of the linearised oscillator, per unit time:
///
///     Re (c_eq - sqrt(c_eq^2 - 4 k_eq)) / 2,
///
/// c_eq/2 below critical damping, about k_eq/c_eq far above it.
double slowest_decay_rate(const EquivalentLinearisation& linear);

/// Mean number of impulses, lambda/kappa, in the time in which the slowest mode of equivalent
/// linearisation decays by a factor e. Between impulses an amplitude a decays like exp(-kappa t).
/// The probability within a then behaves like a^(lambda/kappa): the joint density is unbounded at
/// rest for values below 2, its marginal densities for values below 1.
double impulses_per_decay_time(const Problem& problem);

/// Equilibrium displacement under the mean force of the impulses: g(y) = lambda E[Y] where the
/// impulses push away from the wall, else 0. The Gaussian above does not include this deflection.
double static_deflection(const Problem& problem);

}  // namespace fpkcheck::problem
