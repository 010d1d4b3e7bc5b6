#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// The Gaussian that equivalent linearisation gives for (z, z') under white noise of the same
/// intensity. Independent, zero-mean components.
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

/// The rate at which the slowest mode of the linearised oscillator decays, per unit time:
/// Re (c_eq - sqrt(c_eq^2 - 4 k_eq)) / 2. That is c_eq/2 below critical damping, about k_eq/c_eq
/// far above it.
double slowest_decay(const EquivalentLinearisation& linear);

/// Impulses in the time in which the slowest mode of equivalent linearisation falls by a factor e.
/// Between impulses an amplitude a decays like exp(-kappa t): with lambda/kappa of them the mass
/// within a is like a^(lambda/kappa), so that the joint density is unbounded at rest below 2 and
/// its marginals are below 1.
double impulses_per_decay_time(const Problem& problem);

/// Where the mean of the impulses alone would hold the oscillator: g(y) = lambda E[Y] when
/// they push away from the wall, else 0. The Gaussian above knows nothing of it.
double static_deflection(const Problem& problem);

}  // namespace fpkcheck::problem
