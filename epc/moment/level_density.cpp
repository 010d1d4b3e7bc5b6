#include "epc/moment/level_density.hpp"

#include <cmath>

#include "epc/half_plane/search.hpp"
#include "epc/moment/tail.hpp"

namespace fpkcheck::epc::moment {

double level_density(const half_plane::Shape& shape, const problem::Problem& problem) {
  return std::exp(largest_on_contour(shape.q, problem, shape.level) - shape.peak);
}

double edge_density(const half_plane::Shape& shape, const problem::Problem& problem, Tail tail) {
  const double confined = half_plane::confinement_of(shape.level, tail)(shape.support);
  return std::exp(largest_on_contour(shape.q, problem, shape.support) - shape.peak + confined);
}

}  // namespace fpkcheck::epc::moment
