#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Result of equivalent linearisation: a Gaussian density of the independent variables z and z' of
/// paper (5) with mean zero, under white noise with the intensity of the impulses.
struct EquivalentLinearisation {
  double damping;    ///< equivalent damping coefficient c_eq
  double stiffness;  ///< equivalent stiffness k_eq
  /// Standard deviation sigma_1 of the displacement z, paper (25).
  double displacement_deviation = 0;
  double velocity_deviation = 0;  ///< standard deviation sigma_2 of the velocity z', paper (26)
};

/// Returns whether the problem is the paper's oscillator, for which equivalent_linearisation() is
/// defined. In wall coordinates, the paper's oscillator has one wall, at y = 0 on the left, and the
/// restoring force k y + mu y^3 with k, mu >= 0. The damping force of the paper's oscillator is c
/// y' with c > 0, and impulses act without white noise.
bool has_equivalent_linearisation(const Problem& problem);

/// Solves the equations of equivalent linearisation, where D2 = lambda E[Y^2] / 2 is the diffusion
/// coefficient:
///
///     c_eq = c + (1-r) (2/pi) sigma_2 / sigma_1       (the impulsive damping term of paper (13))
///     k_eq = E[g'(|z|)] = k + 3 mu sigma_1^2
///     sigma_2^2 = D2 / c_eq,   sigma_1 = sigma_2 / sqrt(k_eq).
EquivalentLinearisation equivalent_linearisation(const Problem& problem);

/// Returns the decay rate of the slowest mode of the linearised oscillator, per unit time,
///
///     kappa = Re (c_eq - sqrt(c_eq^2 - 4 k_eq)) / 2.
///
/// The decay rate kappa of the linearised oscillator is c_eq/2 below critical damping, and about
/// k_eq/c_eq far above critical damping.
double slowest_decay_rate(const EquivalentLinearisation& linearised);

/// Returns the mean number lambda/kappa of impulses in the decay time 1/kappa of the slowest mode
/// of equivalent linearisation. Between impulses of the rate lambda the amplitude of the motion
/// decays like exp(-kappa t). Therefore the probability of a motion with an amplitude below a
/// behaves like a^(lambda/kappa) for small a. With the impulse rate lambda and the decay rate
/// kappa, the joint density is unbounded at the state of rest if lambda/kappa < 2; the marginal
/// densities are unbounded if lambda/kappa < 1.
double impulses_per_decay_time(const Problem& problem);

/// Returns the equilibrium displacement y under the mean force of the impulses. The static
/// deflection is the root y of g(y) = lambda E[Y] if the mean impulse points away from the wall,
/// otherwise 0. The Gaussian density of EquivalentLinearisation does not include the static
/// deflection.
double static_deflection(const Problem& problem);

}  // namespace fpkcheck::problem
