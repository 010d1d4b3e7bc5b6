#pragma once

#include <boost/math/quadrature/gauss.hpp>

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

}  // namespace fpkcheck::transform
