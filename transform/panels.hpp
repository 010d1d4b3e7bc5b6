#pragma once

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace fpkcheck::transform {

/// Composite Gauss-Legendre rule: `panels` panels of 10 points on [a, b].
template <class Function>
auto integrate_panels(const Function& f, double a, double b, int panels) {
  const double width = (b - a) / panels;
  auto sum = decltype(f(a)){};
  for (int k = 0; k < panels; ++k) {
    sum += boost::math::quadrature::gauss<double, 10>::integrate(f, a + k * width,
                                                                 a + (k + 1) * width);
  }
  return sum;
}

/// Average over [a, b] by three Gauss-Legendre points, exact to degree 5.
template <class Function>
auto average(const Function& f, double a, double b) {
  const double centre = (a + b) / 2;
  const double offset = (b - a) / 2 * std::sqrt(0.6);
  return (5 * f(centre - offset) + 8 * f(centre) + 5 * f(centre + offset)) / 18;
}

}  // namespace fpkcheck::transform
