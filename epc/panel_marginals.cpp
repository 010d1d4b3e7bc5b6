#include "epc/panel_marginals.hpp"

#include <cmath>

#include "transform/panels.hpp"

namespace fpkcheck::epc {
namespace {

// Panels per half-width: each covers about one standard deviation of a bell that fills the box.
constexpr int kPanels = 8;

double distance(const std::vector<double>& p, const std::vector<double>& q,
                const std::vector<double>& weights) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += weights[i] * std::abs(p[i] - q[i]);
  return sum;
}

}  // namespace

PanelMarginals panel_marginals(const transform::SmoothDensity& density, double y_max,
                               double v_max) {
  const auto y_points = transform::panel_points(0.0, y_max, kPanels);
  auto v_points = transform::panel_points(-v_max, 0.0, kPanels);
  const auto upper = transform::panel_points(0.0, v_max, kPanels);
  v_points.insert(v_points.end(), upper.begin(), upper.end());

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

double distance(const PanelMarginals& a, const PanelMarginals& b) {
  return distance(a.p_y, b.p_y, a.weight_y) + distance(a.p_v, b.p_v, a.weight_v);
}

}  // namespace fpkcheck::epc
