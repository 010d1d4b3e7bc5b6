#include "transform/density.hpp"

namespace fpkcheck::transform {

double mass(const GridDensity& density) {
  double sum = 0;
  for (std::size_t i = 0; i < density.ny(); ++i) {
    double row = 0;
    for (std::size_t j = 0; j < density.nv(); ++j) {
      row += density.average(i, j) * (density.v_edges[j + 1] - density.v_edges[j]);
    }
    sum += row * (density.y_edges[i + 1] - density.y_edges[i]);
  }
  return sum;
}

}  // namespace fpkcheck::transform
