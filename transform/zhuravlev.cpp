#include "transform/zhuravlev.hpp"

#include <utility>

namespace fpkcheck::transform {

SmoothDensity physical_density(PlaneDensity density) {
  const double y_max = density.x1_max;
  const double v_max = density.x2_max;
  return {[p = std::move(density.value)](double y, double v) { return p(y, v) + p(-y, -v); }, y_max,
          v_max};
}

}  // namespace fpkcheck::transform
