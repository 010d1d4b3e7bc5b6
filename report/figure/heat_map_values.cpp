#include "report/figure/heat_map_values.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fpkcheck::report {

using transform::GridDensity;

CellIndexWindow window_of_cells_above_peak_fraction(const GridDensity& density, double part) {
  const double peak = *std::ranges::max_element(density.averages);
  if (!(peak > 0)) return {density.y_cell_count(), 0, density.v_cell_count()};
  CellIndexWindow window{1, density.v_cell_count() - 1, 1};
  if (density.y_edges.front() != 0) window.y_begin = density.y_cell_count() - 1;
  for (std::size_t i = 0; i < density.y_cell_count(); ++i) {
    for (std::size_t j = 0; j < density.v_cell_count(); ++j) {
      if (density.cell_average(i, j) <= part * peak) continue;
      window.y_begin = std::min(window.y_begin, i);
      window.y_end = std::max(window.y_end, i + 1);
      window.v_begin = std::min(window.v_begin, j);
      window.v_end = std::max(window.v_end, j + 1);
    }
  }
  return window;
}

std::vector<double> cell_averages_by_velocity_rows(const GridDensity& density,
                                                   const CellIndexWindow& window) {
  std::vector<double> values;
  for (std::size_t j = window.v_begin; j < window.v_end; ++j) {
    for (std::size_t i = window.y_begin; i < window.y_end; ++i)
      values.push_back(density.cell_average(i, j));
  }
  return values;
}

QuantisedSignedRoots quantise_signed_roots(std::span<const double> values, int levels) {
  QuantisedSignedRoots result{.largest = 0, .levels = levels, .roots = {}};
  for (const double x : values) result.largest = std::max(result.largest, std::abs(x));
  for (const double x : values) {
    const double root = result.largest > 0 ? std::sqrt(std::abs(x) / result.largest) : 0;
    result.roots.push_back(static_cast<int>(std::lround(std::copysign(levels * root, x))));
  }
  return result;
}

std::vector<int> successive_differences(std::span<const int> values) {
  std::vector<int> steps(values.size());
  std::adjacent_difference(values.begin(), values.end(), steps.begin());
  return steps;
}

}  // namespace fpkcheck::report
