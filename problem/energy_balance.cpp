#include "problem/energy_balance.hpp"

namespace fpkcheck::problem {

Power power(const Problem& problem, Impact impact, const EnergyTerms& terms) {
  const double r = problem.system.restitution();
  const double kappa = impact == Impact::delta ? 1 - r : (1 - r * r) / 2;
  return {.input = problem.impulses.rate_moment(2) / 2 +
                   problem.impulses.rate_moment(1) * terms.mean_velocity,
          .dissipated = problem.system.damping() * terms.mean_square_velocity +
                        kappa * terms.impact_energy_flux};
}

double energy_residual(const Problem& problem, Impact impact, const EnergyTerms& terms) {
  const auto [input, dissipated] = power(problem, impact, terms);
  return (input - dissipated) / input;
}

}  // namespace fpkcheck::problem
