#include "transform/joint_density.hpp"

#include <cmath>

#include "numerics/quadrature/gauss_rule.hpp"
#include "transform/conservative_remap.hpp"

namespace fpkcheck::transform {
namespace {

// Number of quadrature panels for half the width of the support of a density. For a Gaussian
// density, each quadrature panel is about one standard deviation wide.
constexpr int kPanels = 8;

}  // namespace

double expectation(const SmoothDensity& density, const std::function<double(double, double)>& g) {
  const auto y_points = numerics::composite_gauss_points(density.y_min, density.y_max,
                                                         density.y_min < 0 ? 2 * kPanels : kPanels);
  auto v_points = numerics::composite_gauss_points(-density.v_max, 0.0, kPanels);
  const auto upper = numerics::composite_gauss_points(0.0, density.v_max, kPanels);
  v_points.insert(v_points.end(), upper.begin(), upper.end());
  double sum = 0;
  for (const auto& [y, y_weight] : y_points) {
    for (const auto& [v, v_weight] : v_points) {
      sum += g(y, v) * (y_weight * v_weight * density.value(y, v));
    }
  }
  return sum;
}

double flux_into_left_wall(const SmoothDensity& density, int power) {
  const auto integrand = [&](double v) { return std::pow(-v, power) * density.value(0, v); };
  return numerics::integrate_by_composite_gauss(integrand, -density.v_max, 0.0, kPanels);
}

GridDensity average_over_cells(const SmoothDensity& density, std::span<const double> y_edges,
                               std::span<const double> v_edges) {
  GridDensity grid{{y_edges.begin(), y_edges.end()}, {v_edges.begin(), v_edges.end()}, {}};
  for (std::size_t i = 0; i < grid.y_cell_count(); ++i) {
    for (std::size_t j = 0; j < grid.v_cell_count(); ++j) {
      const auto over_v = [&](double y) {
        return numerics::gauss_legendre_average([&](double v) { return density.value(y, v); },
                                                v_edges[j], v_edges[j + 1]);
      };
      grid.averages.push_back(numerics::gauss_legendre_average(over_v, y_edges[i], y_edges[i + 1]));
    }
  }
  return grid;
}

GridDensity average_over_cells(const GridDensity& density, std::span<const double> y_edges,
                               std::span<const double> v_edges) {
  const ConservativeRemap along_y(density.y_edges, y_edges), along_v(density.v_edges, v_edges);
  GridDensity grid{{y_edges.begin(), y_edges.end()}, {v_edges.begin(), v_edges.end()}, {}};

  // Masses of cells with new edges in v and old edges in y, one vector for each new cell in v.
  std::vector<std::vector<double>> columns(grid.v_cell_count(),
                                           std::vector<double>(density.y_cell_count()));
  std::vector<double> row(density.v_cell_count());
  for (std::size_t i = 0; i < density.y_cell_count(); ++i) {
    const double dy = density.y_edges[i + 1] - density.y_edges[i];
    for (std::size_t j = 0; j < density.v_cell_count(); ++j) {
      row[j] = density.cell_average(i, j) * dy * (density.v_edges[j + 1] - density.v_edges[j]);
    }
    const auto moved = along_v(row);
    for (std::size_t j = 0; j < grid.v_cell_count(); ++j) columns[j][i] = moved[j];
  }
  grid.averages.resize(grid.y_cell_count() * grid.v_cell_count());
  for (std::size_t j = 0; j < grid.v_cell_count(); ++j) {
    const double dv = v_edges[j + 1] - v_edges[j];
    const auto moved = along_y(columns[j]);
    for (std::size_t i = 0; i < grid.y_cell_count(); ++i) {
      grid.averages[i * grid.v_cell_count() + j] = moved[i] / (dv * (y_edges[i + 1] - y_edges[i]));
    }
  }
  return grid;
}

double mass(const GridDensity& density) {
  double sum = 0;
  for (std::size_t i = 0; i < density.y_cell_count(); ++i) {
    double row = 0;
    for (std::size_t j = 0; j < density.v_cell_count(); ++j) {
      row += density.cell_average(i, j) * (density.v_edges[j + 1] - density.v_edges[j]);
    }
    sum += row * (density.y_edges[i + 1] - density.y_edges[i]);
  }
  return sum;
}

}  // namespace fpkcheck::transform
