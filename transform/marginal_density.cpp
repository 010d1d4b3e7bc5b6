#include "transform/marginal_density.hpp"

#include <cassert>
#include <cmath>
#include <stdexcept>

#include "numerics/quadrature/gauss_rule.hpp"
#include "transform/conservative_remap.hpp"

namespace fpkcheck::transform {
namespace {

std::vector<double> masses_along(const GridDensity& density, StateVariable variable) {
  const bool is_y = variable == StateVariable::y;
  std::vector<double> masses(is_y ? density.y_cell_count() : density.v_cell_count());
  for (std::size_t i = 0; i < density.y_cell_count(); ++i) {
    const double dy = density.y_edges[i + 1] - density.y_edges[i];
    for (std::size_t j = 0; j < density.v_cell_count(); ++j) {
      const double dv = density.v_edges[j + 1] - density.v_edges[j];
      masses[is_y ? i : j] += density.cell_average(i, j) * dy * dv;
    }
  }
  return masses;
}

std::vector<double> bin_averages(const GridDensity& density, StateVariable variable,
                                 std::span<const double> edges) {
  const ConservativeRemap transfer(variable == StateVariable::y ? density.y_edges : density.v_edges,
                                   edges);
  std::vector<double> averages = transfer(masses_along(density, variable));
  for (std::size_t b = 0; b < averages.size(); ++b) averages[b] /= edges[b + 1] - edges[b];
  return averages;
}

std::vector<double> bin_averages(const SmoothDensity& density, StateVariable variable,
                                 std::span<const double> edges) {
  constexpr int kPanelsPerMarginal = 6;
  const auto at = [&](double x) {
    if (variable == StateVariable::y) {
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
    averages.push_back(numerics::gauss_legendre_average(at, edges[b], edges[b + 1]));
  }
  return averages;
}

}  // namespace

Marginal marginal(const Density& density, StateVariable variable, std::span<const double> edges) {
  return {.edges = {edges.begin(), edges.end()},
          .density = std::visit(
              [&](const auto& form) { return bin_averages(form, variable, edges); }, density),
          .lower = {},
          .upper = {}};
}

double l1_distance(const Marginal& a, const Marginal& b) {
  if (a.edges != b.edges || a.size() != b.size()) {
    throw std::invalid_argument("L1 distance undefined: the marginals have different bins");
  }
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sum += std::abs(a.density[k] - b.density[k]) * a.bin_width(k);
  }
  return sum;
}

namespace {

// Number of quadrature panels in y for a density without a wall at y = 0.
constexpr int kPanelsBetweenOpenEnds = 20;

std::vector<numerics::QuadraturePoint> half_line_points(double end, QuadraturePanelSpacing panels) {
  // For a Gaussian density each quadrature panel is about one standard deviation wide.
  constexpr int kUniformPanels = 8;
  if (panels == QuadraturePanelSpacing::uniform)
    return numerics::composite_gauss_points(0.0, end, kUniformPanels);
  constexpr int kGradedPanels = 12;
  constexpr double kGradingExponent = 1.5;  // the last panel is about as wide as a uniform panel
  const auto edge = [&](int k) {
    return end * std::pow(static_cast<double>(k) / kGradedPanels, kGradingExponent);
  };
  constexpr int kGeometricPanels = 5;
  constexpr double kPanelRatio = 0.25;
  std::vector<double> edges{0};
  for (int k = panels == QuadraturePanelSpacing::geometric ? kGeometricPanels : 0; k > 0; --k) {
    edges.push_back(edge(1) * std::pow(kPanelRatio, k));
  }
  for (int k = 1; k <= kGradedPanels; ++k) edges.push_back(edge(k));
  std::vector<numerics::QuadraturePoint> points;
  for (std::size_t k = 1; k < edges.size(); ++k) {
    const auto panel = numerics::composite_gauss_points(edges[k - 1], edges[k], 1);
    points.insert(points.end(), panel.begin(), panel.end());
  }
  return points;
}

double distance(const std::vector<double>& p, const std::vector<double>& q,
                const std::vector<double>& weights) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += weights[i] * std::abs(p[i] - q[i]);
  return sum;
}

}  // namespace

QuadratureMarginals marginals_at_quadrature_points(const SmoothDensity& density, double y_max,
                                                   double v_max, QuadraturePanelSpacing panels) {
  const auto y_points = density.y_min == 0 ? half_line_points(y_max, panels)
                                           : numerics::composite_gauss_points(
                                                 density.y_min, y_max, kPanelsBetweenOpenEnds);
  auto v_points = half_line_points(v_max, panels);
  for (std::size_t j = 0, half = v_points.size(); j < half; ++j) {
    v_points.push_back({-v_points[j].at, v_points[j].weight});
  }

  QuadratureMarginals result;
  result.p_v.assign(v_points.size(), 0.0);
  for (const auto& [v, weight] : v_points) result.weight_v.push_back(weight);
  for (const auto& [y, weight] : y_points) {
    double row = 0;
    for (std::size_t j = 0; j < v_points.size(); ++j) {
      const double p = density.value(y, v_points[j].at);
      row += v_points[j].weight * p;
      result.p_v[j] += weight * p;
    }
    result.y.push_back(y);
    result.weight_y.push_back(weight);
    result.p_y.push_back(row);
    result.mass += weight * row;
    result.moments.y1 += weight * row * y;
    result.moments.y2 += weight * row * y * y;
    result.moments.y4 += weight * row * y * y * y * y;
  }
  for (std::size_t j = 0; j < v_points.size(); ++j) {
    const auto& [v, weight] = v_points[j];
    const double share = weight * result.p_v[j];
    result.moments.v1 += share * v;
    result.moments.v2 += share * v * v;
    result.moments.v4 += share * v * v * v * v;
  }
  return result;
}

double mean_of_displacement_polynomial(const QuadratureMarginals& marginals,
                                       const numerics::Polynomial& g) {
  double sum = 0;
  for (std::size_t i = 0; i < marginals.y.size(); ++i) {
    sum += marginals.weight_y[i] * marginals.p_y[i] * g(marginals.y[i]);
  }
  return sum;
}

double summed_l1_distance(const QuadratureMarginals& a, const QuadratureMarginals& b) {
  assert(a.y == b.y && a.weight_v == b.weight_v);
  return distance(a.p_y, b.p_y, a.weight_y) + distance(a.p_v, b.p_v, a.weight_v);
}

}  // namespace fpkcheck::transform
