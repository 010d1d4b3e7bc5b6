#include "compare/guaranteed_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "compare/solution_assessment.hpp"

namespace fpkcheck::compare {
namespace {

using transform::Moments;
using transform::Solution;

double moment_error_estimate(const Solution& solution, double Moments::*moment) {
  const double stated = solution.error ? std::abs(solution.error->moments.*moment) : 0;
  const double by_chance = solution.standard_errors ? kContradictionStandardErrors *
                                                          solution.standard_errors->moments.*moment
                                                    : 0;
  return stated + by_chance;
}

}  // namespace

const GuaranteedBound* find_moment_bound(const GuaranteedBounds& bounds, double Moments::*moment) {
  const auto* named =
      std::ranges::find(transform::kMoments, moment, &transform::NamedMoment::moment);
  if (named == std::end(transform::kMoments)) return nullptr;
  const auto found = std::ranges::find(bounds.each, named->symbol, &GuaranteedBound::functional);
  return found == bounds.each.end() ? nullptr : &*found;
}

std::vector<BoundViolation> bound_violations(const GuaranteedBounds& bounds,
                                             std::span<const Solution> solutions) {
  std::vector<BoundViolation> found;
  for (const Solution& solution : solutions) {
    if (!solution.has_density()) continue;
    for (const auto& [name, symbol, moment, size] : transform::kMoments) {
      const GuaranteedBound* bound = find_moment_bound(bounds, moment);
      if (bound == nullptr) continue;
      const double value = solution.moments.*moment;
      const double excess = std::max(bound->lower - value, value - bound->upper);
      // If a density file has only one marginal density, the moments of the other variable are NaN.
      if (!std::isfinite(value) || !(excess > 0)) continue;
      found.push_back({&solution, bound, value, excess, moment_error_estimate(solution, moment)});
    }
  }
  return found;
}

std::vector<BoundViolation> violations_beyond_error_estimate(const GuaranteedBounds& bounds,
                                                             std::span<const Solution> solutions) {
  std::vector<BoundViolation> found = bound_violations(bounds, solutions);
  std::erase_if(found, [](const BoundViolation& one) {
    return !is_solution_of_full_problem(*one.solution) || !one.exceeds_error_estimate();
  });
  return found;
}

}  // namespace fpkcheck::compare
