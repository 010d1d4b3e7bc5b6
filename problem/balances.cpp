#include "problem/balances.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::problem {

PowerBalance power_balance(const Problem& problem, ImpactCondition impact,
                           const PowerBalanceTerms& terms) {
  const System& system = problem.system;
  const auto kappa = [&](double r) {
    return impact == ImpactCondition::delta ? 1 - r : (1 - r * r) / 2;
  };
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

double energy_residual(const Problem& problem, ImpactCondition impact,
                       const PowerBalanceTerms& terms) {
  const auto [input, dissipated] = power_balance(problem, impact, terms);
  return (input - dissipated) / input;
}

BalanceEquation virial_balance(const Problem& problem, const VirialBalanceTerms& terms) {
  const System& system = problem.system;
  double right =
      terms.mean_virial - problem.impulses.rate_times_moment(1) * terms.mean_displacement;
  if (system.has_polynomial_force() && system.rayleigh_coefficient() != 0)
    right += system.rayleigh_coefficient() * terms.mean_y_cubed_velocity;
  if (const auto& wall = system.right_wall()) {
    right += (1 + wall->restitution) * wall->position * terms.right_momentum;
  }
  return {.left = terms.mean_square_velocity, .right = right, .scale = terms.mean_square_velocity};
}

BalanceEquation momentum_balance(const Problem& problem, const MomentumBalanceTerms& terms) {
  const System& system = problem.system;
  double taken = terms.mean_force;
  if (system.has_polynomial_force() && system.rayleigh_coefficient() != 0)
    taken += system.rayleigh_coefficient() * terms.mean_cubed_velocity;
  double given = 0, from_walls = 0;
  if (system.left_wall()) given += (1 + system.restitution()) * terms.impact_momentum;
  given += terms.contact_momentum_rate;
  from_walls = std::abs(given);
  if (const auto& wall = system.right_wall()) {
    const double back = (1 + wall->restitution) * terms.right_momentum;
    from_walls += back;
    given -= back;
  }
  return {.left = taken,
          .right = problem.impulses.rate_times_moment(1) + given,
          .scale = std::max({std::abs(taken), from_walls, terms.mean_absolute_force})};
}

}  // namespace fpkcheck::problem
