#include "epc/moment/density_at_level.hpp"

#include <cmath>

#include "epc/half_plane/root_search.hpp"
#include "epc/moment/contour_decay.hpp"

namespace fpkcheck::epc::moment {

double density_ratio_at_level(const half_plane::ClosureDensity& closure,
                              const problem::Problem& problem) {
  return std::exp(largest_exponent_on_contour(closure.q, problem, closure.level) - closure.peak);
}

double density_ratio_at_edge(const half_plane::ClosureDensity& closure,
                             const problem::Problem& problem, TailTreatment tail) {
  const double confined = half_plane::confinement_of(closure.level, tail)(closure.support);
  return std::exp(largest_exponent_on_contour(closure.q, problem, closure.support) - closure.peak +
                  confined);
}

}  // namespace fpkcheck::epc::moment
