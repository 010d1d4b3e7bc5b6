#include <cmath>

#include "numerics/quadrature/composite_gauss.hpp"
#include "transform/density.hpp"

namespace fpkcheck::transform {
namespace {

// Number of panels for half the width of the support. For a Gaussian density, each panel is about
// one standard deviation wide.
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

double impact_flux(const SmoothDensity& density, int power) {
  const auto integrand = [&](double v) { return std::pow(-v, power) * density.value(0, v); };
  return numerics::integrate_by_composite_gauss(integrand, -density.v_max, 0.0, kPanels);
}

GridDensity average_over_cells(const SmoothDensity& density, std::span<const double> y_edges,
                               std::span<const double> v_edges) {
  GridDensity grid{{y_edges.begin(), y_edges.end()}, {v_edges.begin(), v_edges.end()}, {}};
  for (std::size_t i = 0; i < grid.ny(); ++i) {
    for (std::size_t j = 0; j < grid.nv(); ++j) {
      const auto over_v = [&](double y) {
        return numerics::gauss_average([&](double v) { return density.value(y, v); }, v_edges[j],
                                       v_edges[j + 1]);
      };
      grid.averages.push_back(numerics::gauss_average(over_v, y_edges[i], y_edges[i + 1]));
    }
  }
  return grid;
}

}  // namespace fpkcheck::transform
