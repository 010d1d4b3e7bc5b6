#pragma once

#include <Eigen/Core>
#include <boost/math/quadrature/gauss.hpp>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace fpkcheck::numerics {

struct QuadraturePoint {
  double at;
  double weight;
};

/// Returns the points of the composite Gauss-Legendre rule on [a, b], with N points on each of
/// `panels` panels of equal width. The composite rule is exact for polynomials of degree 2 N - 1 on
/// each panel. The quadrature points of a panel are ordered in pairs symmetric about the middle of
/// the panel.
/// @pre panels > 0
template <unsigned N = 10>
std::vector<QuadraturePoint> composite_gauss_points(double a, double b, int panels) {
  assert(panels > 0);
  using Rule = boost::math::quadrature::gauss<double, N>;  // Boost stores only the abscissas >= 0
  const double half_width = (b - a) / panels / 2;
  std::vector<QuadraturePoint> points;
  points.reserve(N * static_cast<std::size_t>(panels));
  for (int k = 0; k < panels; ++k) {
    const double centre = a + (2 * k + 1) * half_width;
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      const double offset = half_width * Rule::abscissa()[i];
      const double weight = half_width * Rule::weights()[i];
      if (offset != 0) points.push_back({centre - offset, weight});
      points.push_back({centre + offset, weight});
    }
  }
  return points;
}

struct QuadratureRule {
  std::vector<double> points;
  Eigen::VectorXd weights;

  Eigen::Index size() const { return weights.size(); }
  /// Returns a view of the quadrature points as an Eigen vector, valid during the lifetime of the
  /// quadrature rule.
  Eigen::Map<const Eigen::VectorXd> quadrature_points_as_vector() const {
    return {points.data(), size()};
  }
};

/// Returns the composite Gauss-Legendre rule with N points on each panel, for panels of different
/// widths.
/// @param panel_ends ends of the panels in increasing order, at least two; equal ends are allowed
template <unsigned N>
QuadratureRule composite_gauss_rule(std::span<const double> panel_ends) {
  QuadratureRule rule;
  rule.weights.resize(static_cast<Eigen::Index>(N * (panel_ends.size() - 1)));
  for (std::size_t panel = 0; panel + 1 < panel_ends.size(); ++panel) {
    if (panel_ends[panel] == panel_ends[panel + 1]) continue;
    for (const auto& [at, weight] :
         composite_gauss_points<N>(panel_ends[panel], panel_ends[panel + 1], 1)) {
      rule.weights(static_cast<Eigen::Index>(rule.points.size())) = weight;
      rule.points.push_back(at);
    }
  }
  rule.weights.conservativeResize(static_cast<Eigen::Index>(rule.points.size()));
  return rule;
}

/// Returns the Gauss-Legendre rule on the interval [from, to], with the points in increasing order.
/// @pre point_count > 0
QuadratureRule gauss_legendre_rule(int point_count, double from, double to);

/// Returns the Gauss-Hermite rule for E[g(u)] with a standard normal variable u, exact for
/// polynomials g up to `degree`.
QuadratureRule gauss_hermite_rule(int degree);

/// Returns a quadrature rule for E[|u| g(u)] with a standard normal variable u, exact for
/// polynomials g up to `degree`.
QuadratureRule normal_rule_weighted_by_abs(int degree);

/// Returns a quadrature rule for E[sgn(u) g(u)] with a standard normal variable u, exact for
/// polynomials g up to `degree`; some weights are negative.
QuadratureRule normal_rule_weighted_by_sign(int degree);

/// Returns the Gauss-Laguerre rule for int_0^inf g(t) exp(-t) dt, exact for polynomials g up to
/// `degree`.
QuadratureRule gauss_laguerre_rule(int degree);

template <class Function>
double integrate_by_composite_gauss(const Function& f, double a, double b, int panels) {
  double sum = 0;
  for (const auto& [at, weight] : composite_gauss_points(a, b, panels)) sum += weight * f(at);
  return sum;
}

/// Averages f over [a, b] with the three-point Gauss-Legendre rule, which is exact for polynomials
/// up to degree 5.
template <class Function>
auto gauss_legendre_average(const Function& f, double a, double b) {
  const double centre = (a + b) / 2;
  const double offset = (b - a) / 2 * std::sqrt(0.6);
  return (5 * f(centre - offset) + 8 * f(centre) + 5 * f(centre + offset)) / 18;
}

}  // namespace fpkcheck::numerics
