#include "problem/energy_balance.hpp"

namespace fpkcheck::problem {

PowerBalance power_balance(const Problem& problem, Impact impact, const EnergyTerms& terms) {
  const System& system = problem.system;
  const auto kappa = [&](double r) { return impact == Impact::delta ? 1 - r : (1 - r * r) / 2; };
  PowerBalance power{.input = problem.impulses.rate_times_moment(2) / 2 +
                              problem.impulses.rate_times_moment(1) * terms.mean_velocity,
                     .dissipated = system.has_constant_damping()
                                       ? system.damping() * terms.mean_square_velocity
                                       : terms.mean_damping_power};
  power.input += problem.noise.diffusion();
  if (system.left_wall())
    power.dissipated += kappa(system.restitution()) * terms.impact_energy_flux;
  if (system.right_wall()) {
    power.dissipated += kappa(system.right_wall()->restitution) * terms.right_energy_flux;
  }
  return power;
}

double energy_residual(const Problem& problem, Impact impact, const EnergyTerms& terms) {
  const auto [input, dissipated] = power_balance(problem, impact, terms);
  return (input - dissipated) / input;
}

}  // namespace fpkcheck::problem
