#include "transform/conservative_remap.hpp"
#include "transform/density.hpp"

namespace fpkcheck::transform {

GridDensity average_over_cells(const GridDensity& density, std::span<const double> y_edges,
                               std::span<const double> v_edges) {
  const ConservativeRemap along_y(density.y_edges, y_edges), along_v(density.v_edges, v_edges);
  GridDensity grid{{y_edges.begin(), y_edges.end()}, {v_edges.begin(), v_edges.end()}, {}};

  // Masses over (new v cell, old y cell), one column of the new grid after the other.
  std::vector<std::vector<double>> columns(grid.nv(), std::vector<double>(density.ny()));
  std::vector<double> row(density.nv());
  for (std::size_t i = 0; i < density.ny(); ++i) {
    const double dy = density.y_edges[i + 1] - density.y_edges[i];
    for (std::size_t j = 0; j < density.nv(); ++j) {
      row[j] = density.cell_average(i, j) * dy * (density.v_edges[j + 1] - density.v_edges[j]);
    }
    const auto moved = along_v(row);
    for (std::size_t j = 0; j < grid.nv(); ++j) columns[j][i] = moved[j];
  }
  grid.averages.resize(grid.ny() * grid.nv());
  for (std::size_t j = 0; j < grid.nv(); ++j) {
    const double dv = v_edges[j + 1] - v_edges[j];
    const auto moved = along_y(columns[j]);
    for (std::size_t i = 0; i < grid.ny(); ++i) {
      grid.averages[i * grid.nv() + j] = moved[i] / (dv * (y_edges[i + 1] - y_edges[i]));
    }
  }
  return grid;
}

double mass(const GridDensity& density) {
  double sum = 0;
  for (std::size_t i = 0; i < density.ny(); ++i) {
    double row = 0;
    for (std::size_t j = 0; j < density.nv(); ++j) {
      row += density.cell_average(i, j) * (density.v_edges[j + 1] - density.v_edges[j]);
    }
    sum += row * (density.y_edges[i + 1] - density.y_edges[i]);
  }
  return sum;
}

}  // namespace fpkcheck::transform
