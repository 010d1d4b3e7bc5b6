#include "transform/marginal.hpp"

#include <cmath>
#include <stdexcept>

#include "numerics/quadrature/composite_gauss.hpp"
#include "transform/conservative_remap.hpp"

namespace fpkcheck::transform {
namespace {

std::vector<double> masses_along(const GridDensity& density, Variable variable) {
  const bool is_y = variable == Variable::y;
  std::vector<double> masses(is_y ? density.ny() : density.nv());
  for (std::size_t i = 0; i < density.ny(); ++i) {
    const double dy = density.y_edges[i + 1] - density.y_edges[i];
    for (std::size_t j = 0; j < density.nv(); ++j) {
      const double dv = density.v_edges[j + 1] - density.v_edges[j];
      masses[is_y ? i : j] += density.cell_average(i, j) * dy * dv;
    }
  }
  return masses;
}

std::vector<double> bin_averages(const GridDensity& density, Variable variable,
                                 std::span<const double> edges) {
  const ConservativeRemap transfer(variable == Variable::y ? density.y_edges : density.v_edges,
                                   edges);
  std::vector<double> averages = transfer(masses_along(density, variable));
  for (std::size_t b = 0; b < averages.size(); ++b) averages[b] /= edges[b + 1] - edges[b];
  return averages;
}

std::vector<double> bin_averages(const SmoothDensity& density, Variable variable,
                                 std::span<const double> edges) {
  constexpr int kPanelsPerMarginal = 6;
  const auto at = [&](double x) {
    if (variable == Variable::y) {
      const auto p = [&](double v) { return density.value(x, v); };
      return numerics::integrate_by_composite_gauss(p, -density.v_max, 0.0, kPanelsPerMarginal) +
             numerics::integrate_by_composite_gauss(p, 0.0, density.v_max, kPanelsPerMarginal);
    }
    return numerics::integrate_by_composite_gauss(
        [&](double y) { return density.value(y, x); }, density.y_min, density.y_max,
        density.y_min < 0 ? 2 * kPanelsPerMarginal : kPanelsPerMarginal);
  };
  std::vector<double> averages;
  for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
    averages.push_back(numerics::gauss_average(at, edges[b], edges[b + 1]));
  }
  return averages;
}

}  // namespace

Marginal marginal(const Density& density, Variable variable, std::span<const double> edges) {
  return {.edges = {edges.begin(), edges.end()},
          .density = std::visit(
              [&](const auto& form) { return bin_averages(form, variable, edges); }, density),
          .lower = {},
          .upper = {}};
}

double l1(const Marginal& a, const Marginal& b) {
  if (a.edges != b.edges || a.size() != b.size()) {
    throw std::invalid_argument("L1 distance undefined: the marginals have different bins");
  }
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sum += std::abs(a.density[k] - b.density[k]) * a.width(k);
  }
  return sum;
}

}  // namespace fpkcheck::transform
