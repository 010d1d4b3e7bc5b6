#include "epc/moment/level_density.hpp"

#include <cmath>

#include "epc/half_plane/search.hpp"
#include "epc/moment/tail.hpp"

namespace fpkcheck::epc::moment {

double level_density(const half_plane::ClosureDensity& closure, const problem::Problem& problem) {
  return std::exp(largest_on_contour(closure.q, problem, closure.level) - closure.peak);
}

double edge_density(const half_plane::ClosureDensity& closure, const problem::Problem& problem,
                    Tail tail) {
  const double confined = half_plane::confinement_of(closure.level, tail)(closure.support);
  return std::exp(largest_on_contour(closure.q, problem, closure.support) - closure.peak +
                  confined);
}

}  // namespace fpkcheck::epc::moment
