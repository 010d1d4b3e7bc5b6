#include "transform/panel_marginals.hpp"

#include <cmath>

#include "numerics/quadrature/composite_gauss.hpp"

namespace fpkcheck::transform {
namespace {

// Number of panels of y for a density without a wall at y = 0.
constexpr int kPanelsBetweenOpenEnds = 20;

std::vector<numerics::QuadraturePoint> half_line_points(double end, PanelSpacing panels) {
  // For a Gaussian density whose support is the domain, each panel is about one standard deviation
  // wide.
  constexpr int kUniformPanels = 8;
  if (panels == PanelSpacing::uniform)
    return numerics::composite_gauss_points(0.0, end, kUniformPanels);
  constexpr int kGradedPanels = 12;
  constexpr double kGradingExponent =
      1.5;  // exponent of the grading; the last panel is then about as wide as a uniform panel
  const auto edge = [&](int k) {
    return end * std::pow(static_cast<double>(k) / kGradedPanels, kGradingExponent);
  };
  constexpr int kGeometricPanels = 5;
  constexpr double kPanelRatio = 0.25;
  std::vector<double> edges{0};
  for (int k = panels == PanelSpacing::geometric ? kGeometricPanels : 0; k > 0; --k) {
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

PanelMarginals panel_marginals(const SmoothDensity& density, double y_max, double v_max,
                               PanelSpacing panels) {
  const auto y_points = density.y_min == 0 ? half_line_points(y_max, panels)
                                           : numerics::composite_gauss_points(
                                                 density.y_min, y_max, kPanelsBetweenOpenEnds);
  auto v_points = half_line_points(v_max, panels);
  for (std::size_t j = 0, half = v_points.size(); j < half; ++j) {
    v_points.push_back({-v_points[j].at, v_points[j].weight});
  }

  PanelMarginals result;
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

double mean_of_displacement_polynomial(const PanelMarginals& marginals,
                                       const numerics::Polynomial& g) {
  double sum = 0;
  for (std::size_t i = 0; i < marginals.y.size(); ++i) {
    sum += marginals.weight_y[i] * marginals.p_y[i] * g(marginals.y[i]);
  }
  return sum;
}

double distance(const PanelMarginals& a, const PanelMarginals& b) {
  return distance(a.p_y, b.p_y, a.weight_y) + distance(a.p_v, b.p_v, a.weight_v);
}

}  // namespace fpkcheck::transform
