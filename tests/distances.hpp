#pragma once

#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "transform/solution.hpp"

namespace fpkcheck::tests {

/// L1 distances of both marginal densities to bin averages on the grid of the solution.
template <class Y, class V>
std::pair<double, double> distances(const transform::Solution& solution, const Y& y, const V& v) {
  const auto& grid = std::get<transform::GridDensity>(*solution.density);
  const auto sum = [&](transform::StateVariable variable, const std::vector<double>& edges,
                       const std::vector<double>& exact) {
    const auto marginal = transform::marginal(solution, variable, edges);
    double total = 0;
    for (std::size_t b = 0; b < exact.size(); ++b) {
      total += std::abs(marginal.density[b] - exact[b]) * marginal.bin_width(b);
    }
    return total;
  };
  return {sum(transform::StateVariable::y, grid.y_edges, y(grid.y_edges)),
          sum(transform::StateVariable::ydot, grid.v_edges, v(grid.v_edges))};
}

}  // namespace fpkcheck::tests
