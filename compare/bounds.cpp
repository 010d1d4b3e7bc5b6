#include "compare/bounds.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::compare {
namespace {

using transform::Moments;
using transform::Solution;

double stated_error(const Solution& solution, double Moments::*moment) {
  const double stated = solution.error ? std::abs(solution.error->moments.*moment) : 0;
  const double by_chance =
      solution.standard_errors ? kSureErrors * solution.standard_errors->moments.*moment : 0;
  return std::max(stated, by_chance);
}

}  // namespace

std::vector<Outside> outside(const Bounds& bounds, std::span<const Solution> solutions) {
  std::vector<Outside> found;
  for (const Solution& solution : solutions) {
    if (!solution.has_density()) continue;
    for (const Bound& bound : bounds.each) {
      const auto* named =
          std::ranges::find(transform::kMoments, bound.functional, &transform::NamedMoment::symbol);
      if (named == std::end(transform::kMoments)) continue;
      const double value = solution.moments.*named->moment;
      const double by = std::max(bound.lower - value, value - bound.upper);
      // A file of one marginal leaves the moments of the other unknown.
      if (!std::isfinite(value) || !(by > 0)) continue;
      found.push_back({&solution, &bound, value, by, stated_error(solution, named->moment)});
    }
  }
  return found;
}

}  // namespace fpkcheck::compare
