#include <cmath>

#include "transform/density.hpp"
#include "transform/panels.hpp"

namespace fpkcheck::transform {
namespace {

// Panels per half-width: each covers about one standard deviation of a bell that fills the support.
constexpr int kPanels = 8;

}  // namespace

double expectation(const SmoothDensity& density, const std::function<double(double, double)>& g) {
  const auto over_v = [&](double y) {
    const auto integrand = [&](double v) { return g(y, v) * density.value(y, v); };
    return integrate_panels(integrand, -density.v_max, 0.0, kPanels) +
           integrate_panels(integrand, 0.0, density.v_max, kPanels);
  };
  return integrate_panels(over_v, 0.0, density.y_max, kPanels);
}

double impact_flux(const SmoothDensity& density, int power) {
  const auto integrand = [&](double v) { return std::pow(-v, power) * density.value(0, v); };
  return integrate_panels(integrand, -density.v_max, 0.0, kPanels);
}

Moments moments(const SmoothDensity& density) {
  const auto of = [&](auto g) { return expectation(density, g); };
  return {.y1 = of([](double y, double) { return y; }),
          .y2 = of([](double y, double) { return y * y; }),
          .y4 = of([](double y, double) { return y * y * y * y; }),
          .v1 = of([](double, double v) { return v; }),
          .v2 = of([](double, double v) { return v * v; }),
          .v4 = of([](double, double v) { return v * v * v * v; })};
}

GridDensity on_cells(const SmoothDensity& density, std::span<const double> y_edges,
                     std::span<const double> v_edges) {
  GridDensity grid{{y_edges.begin(), y_edges.end()}, {v_edges.begin(), v_edges.end()}, {}};
  for (std::size_t i = 0; i < grid.ny(); ++i) {
    for (std::size_t j = 0; j < grid.nv(); ++j) {
      const auto over_v = [&](double y) {
        return average([&](double v) { return density.value(y, v); }, v_edges[j], v_edges[j + 1]);
      };
      grid.averages.push_back(average(over_v, y_edges[i], y_edges[i + 1]));
    }
  }
  return grid;
}

}  // namespace fpkcheck::transform
