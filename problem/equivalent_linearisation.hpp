#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// The result of equivalent linearisation: a Gaussian density of (z, z') under white noise that has
/// the intensity of the impulses. z and z' are independent and have mean zero.
struct EquivalentLinearisation {
  double damping;                     ///< equivalent damping c_eq
  double stiffness;                   ///< equivalent stiffness k_eq
  double displacement_deviation = 0;  ///< standard deviation sigma_1 of z, paper (25)
  double velocity_deviation = 0;      ///< standard deviation sigma_2 of z', paper (26)
};

/// Whether the formulas of equivalent_linearisation() hold: one wall, at y = 0 on the left, at the
/// equilibrium of a restoring force g = k y + mu y^3 with k, mu >= 0, which therefore is an odd
/// function in Zhuravlev's coordinates; damping force f = c y' with c > 0; impulses without noise.
/// The conditions apply to the coordinates of wall_frame().
bool has_equivalent_linearisation(const Problem& problem);

/// Solves the equations of equivalent linearisation, with D2 = lambda E[Y^2] / 2:
///
///     c_eq = c + (1-r) (2/pi) sigma_2 / sigma_1       (the impulsive damping term of paper (13))
///     k_eq = E[g'(|z|)] = k + 3 mu sigma_1^2
///     sigma_2^2 = D2 / c_eq,   sigma_1 = sigma_2 / sqrt(k_eq).
EquivalentLinearisation equivalent_linearisation(const Problem& problem);

/// Decay rate of the slowest mode of the linearised oscillator, per unit time:
///
///     Re (c_eq - sqrt(c_eq^2 - 4 k_eq)) / 2,
///
/// that is, c_eq/2 below critical damping, and about k_eq/c_eq far above critical damping.
double slowest_decay_rate(const EquivalentLinearisation& linear);

/// Mean number of impulses, lambda/kappa, in the time 1/kappa in which the slowest mode of
/// equivalent linearisation decays by a factor e. Between impulses the amplitude of the motion
/// decays like exp(-kappa t). The probability of an amplitude below a therefore behaves like
/// a^(lambda/kappa) for small a. If lambda/kappa < 2, the joint density is unbounded at the state
/// of rest; if lambda/kappa < 1, the marginal densities are unbounded too.
double impulses_per_decay_time(const Problem& problem);

/// Equilibrium displacement y under the mean force of the impulses, the root of g(y) = lambda E[Y]
/// if the impulses push away from the wall; otherwise 0. The Gaussian density of
/// EquivalentLinearisation does not include this deflection.
double static_deflection(const Problem& problem);

}  // namespace fpkcheck::problem
