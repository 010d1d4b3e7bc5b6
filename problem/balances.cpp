#include "problem/balances.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace fpkcheck::problem {

double energy_loss_at_impact(const Wall& wall, ImpactCondition condition, double impact_speed) {
  const double r = wall.restitution_at_speed(impact_speed);
  return (condition == ImpactCondition::delta ? 1 - r : (1 - r * r) / 2) * impact_speed *
         impact_speed;
}

double momentum_change_at_impact(const Wall& wall, double impact_speed) {
  return (1 + wall.restitution_at_speed(impact_speed)) * impact_speed;
}

double impact_energy_loss_rate(const std::optional<Wall>& wall, ImpactCondition condition,
                               double cubed_speed_integral) {
  if (!wall) return 0;
  assert(wall->has_constant_restitution());
  return energy_loss_at_impact(*wall, condition, 1) * cubed_speed_integral;
}

double impact_momentum_rate(const std::optional<Wall>& wall, double squared_speed_integral) {
  if (!wall) return 0;
  assert(wall->has_constant_restitution());
  return momentum_change_at_impact(*wall, 1) * squared_speed_integral;
}

PowerBalance power_balance(const Problem& problem, const PowerBalanceTerms& terms) {
  const System& system = problem.system;
  const double damping_power = system.has_constant_damping()
                                   ? system.damping() * terms.mean_square_velocity
                                   : terms.mean_damping_power;
  return {.input = problem.impulses.rate_times_moment(2) / 2 * terms.mean_square_impulse_factor +
                   problem.impulses.rate_times_moment(1) * terms.mean_velocity +
                   problem.noise.diffusion() * terms.mean_square_noise_factor,
          .dissipated = damping_power + terms.left_impact_loss + terms.right_impact_loss};
}

double power_balance_residual(const Problem& problem, const PowerBalanceTerms& terms) {
  const auto [input, dissipated] = power_balance(problem, terms);
  return (input - dissipated) / input;
}

BalanceEquation virial_balance(const Problem& problem, const VirialBalanceTerms& terms) {
  const System& system = problem.system;
  double right =
      terms.mean_virial - problem.impulses.rate_times_moment(1) * terms.mean_displacement;
  if (system.has_polynomial_force() && system.rayleigh_coefficient() != 0)
    right += system.rayleigh_coefficient() * terms.mean_y_cubed_velocity;
  if (const auto& wall = system.right_wall()) {
    right += wall->position * terms.right_impact_momentum;
  }
  return {.left = terms.mean_square_velocity, .right = right, .scale = terms.mean_square_velocity};
}

BalanceEquation momentum_balance(const Problem& problem, const MomentumBalanceTerms& terms) {
  const System& system = problem.system;
  double taken = terms.mean_force;
  if (system.has_polynomial_force() && system.rayleigh_coefficient() != 0)
    taken += system.rayleigh_coefficient() * terms.mean_cubed_velocity;
  const double from_left = terms.left_impact_momentum + terms.contact_momentum_rate;
  const double given = from_left - terms.right_impact_momentum;
  const double from_walls = std::abs(from_left) + terms.right_impact_momentum;
  return {.left = taken,
          .right = problem.impulses.rate_times_moment(1) + given,
          .scale = std::max({std::abs(taken), from_walls, terms.mean_absolute_force})};
}

}  // namespace fpkcheck::problem
