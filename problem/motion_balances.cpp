#include "problem/motion_balances.hpp"

#include <algorithm>

namespace fpkcheck::problem {

Balance virial_balance(const Problem& problem, const VirialTerms& terms) {
  return {.left = terms.mean_square_velocity,
          .right = terms.mean_virial - problem.impulses.rate_moment(1) * terms.mean_displacement,
          .scale = terms.mean_square_velocity};
}

Balance momentum_balance(const Problem& problem, const MomentumTerms& terms) {
  const double from_wall = (1 + problem.system.restitution()) * terms.impact_momentum;
  return {.left = terms.mean_force,
          .right = problem.impulses.rate_moment(1) + from_wall,
          .scale = std::max(terms.mean_force, from_wall)};
}

}  // namespace fpkcheck::problem
