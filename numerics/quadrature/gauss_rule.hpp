#pragma once

#include <Eigen/Core>
#include <boost/math/quadrature/gauss.hpp>
#include <cstddef>
#include <span>
#include <vector>

namespace fpkcheck::numerics {

/// Points and weights of a quadrature rule; both lists have the same length.
struct QuadratureRule {
  std::vector<double> points;
  Eigen::VectorXd weights;

  Eigen::Index size() const { return weights.size(); }
  /// The points as a vector for matrix products, valid as long as the rule.
  Eigen::Map<const Eigen::VectorXd> point_vector() const { return {points.data(), size()}; }
};

/// Composite Gauss-Legendre rule with N points on each panel. A panel is the interval between two
/// neighbouring ends. The rule is exact for functions that are polynomials of degree 2 N - 1 on
/// each panel. The points of a panel are ordered in pairs symmetric about the middle of the panel.
/// @param panel_ends increasing ends of the panels
template <unsigned N>
QuadratureRule composite_gauss_rule(std::span<const double> panel_ends) {
  using Gauss = boost::math::quadrature::gauss<double, N>;
  QuadratureRule rule;
  std::vector<double> weights;
  for (std::size_t panel = 0; panel + 1 < panel_ends.size(); ++panel) {
    const double centre = (panel_ends[panel] + panel_ends[panel + 1]) / 2;
    const double half = (panel_ends[panel + 1] - panel_ends[panel]) / 2;
    for (std::size_t n = 0; n < Gauss::abscissa().size(); ++n) {
      for (const double sign : {-1.0, 1.0}) {
        if (sign < 0 && Gauss::abscissa()[n] == 0) continue;  // the middle point has no partner
        rule.points.push_back(centre + sign * half * Gauss::abscissa()[n]);
        weights.push_back(half * Gauss::weights()[n]);
      }
    }
  }
  rule.weights =
      Eigen::Map<const Eigen::VectorXd>(weights.data(), static_cast<Eigen::Index>(weights.size()));
  return rule;
}

/// Gauss-Legendre rule on [from, to] with increasing points.
/// @pre point_count > 0
QuadratureRule gauss_legendre_rule(int point_count, double from, double to);

/// Gauss-Hermite rule for E[g(u)] with a standard normal variable u. The rule is exact for
/// polynomials g up to the given degree.
QuadratureRule normal_quadrature_rule(int degree);

/// Rule for E[|u| g(u)] with a standard normal variable u. The rule is exact for polynomials g up to
/// the given degree.
QuadratureRule absolute_weighted_normal_rule(int degree);

/// Rule for E[sgn(u) g(u)] with a standard normal variable u. The rule is exact for polynomials g up
/// to the given degree; some weights are negative.
QuadratureRule sign_weighted_normal_rule(int degree);

/// Gauss-Laguerre rule for int_0^inf g(t) exp(-t) dt. The rule is exact for polynomials g up to the
/// given degree.
QuadratureRule exponential_quadrature_rule(int degree);

}  // namespace fpkcheck::numerics
