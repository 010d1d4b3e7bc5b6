#include "sweep/result/groups.hpp"

#include <cmath>

#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::sweep {

Groups groups_of(const problem::Problem& problem) {
  const auto& system = problem.system.coefficients();
  const double stiffness = problem::equivalent_linearisation(problem).stiffness;
  return {.impulses_per_decay_time = problem::impulses_per_decay_time(problem),
          .damping_ratio = system.damping / (2 * std::sqrt(stiffness)),
          .cubic_share = 1 - system.stiffness / stiffness};
}

}  // namespace fpkcheck::sweep
