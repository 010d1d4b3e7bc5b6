#include "workflows/sweep/result/dimensionless_groups.hpp"

#include <limits>

#include "problem/features.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::sweep {

DimensionlessGroups dimensionless_groups(const problem::Problem& problem) {
  const auto& system = problem.system.coefficients();
  const auto scales = problem::scales(problem);
  const double stiffness = scales.frequency * scales.frequency;
  const bool original = problem::is_paper_oscillator(problem);
  return {.impulses_per_decay_time = problem::impulses_per_decay_time(problem, scales),
          .damping_ratio = system.damping / (2 * scales.frequency),
          .cubic_share = original ? 1 - system.stiffness / stiffness
                                  : std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace fpkcheck::sweep
