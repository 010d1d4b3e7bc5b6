#pragma once

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <vector>

namespace fpkcheck::numerics {

/// A point of a quadrature rule, with its weight.
struct QuadraturePoint {
  double at;
  double weight;
};

/// Points and weights of the composite Gauss-Legendre rule on [a, b], with `panels` panels of equal
/// width and 10 points on each panel.
inline std::vector<QuadraturePoint> composite_gauss_points(double a, double b, int panels) {
  using Rule =
      boost::math::quadrature::gauss<double, 10>;  // Boost stores the half with positive abscissas
  const double half_width = (b - a) / panels / 2;
  std::vector<QuadraturePoint> points;
  for (int k = 0; k < panels; ++k) {
    const double centre = a + (2 * k + 1) * half_width;
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      const double offset = half_width * Rule::abscissa()[i];
      const double weight = half_width * Rule::weights()[i];
      points.push_back({centre - offset, weight});
      points.push_back({centre + offset, weight});
    }
  }
  return points;
}

/// The integral of f over [a, b], computed with the quadrature rule of composite_gauss_points().
template <class Function>
double integrate_by_composite_gauss(const Function& f, double a, double b, int panels) {
  double sum = 0;
  for (const auto& [at, weight] : composite_gauss_points(a, b, panels)) sum += weight * f(at);
  return sum;
}

/// The average of f over [a, b], computed with the three-point Gauss-Legendre rule. The rule is
/// exact for polynomials up to degree 5.
template <class Function>
auto gauss_average(const Function& f, double a, double b) {
  const double centre = (a + b) / 2;
  const double offset = (b - a) / 2 * std::sqrt(0.6);
  return (5 * f(centre - offset) + 8 * f(centre) + 5 * f(centre + offset)) / 18;
}

}  // namespace fpkcheck::numerics
