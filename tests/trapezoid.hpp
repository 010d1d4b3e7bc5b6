#pragma once

/// Quadrature for the tests, of its own so that the solvers' rules are judged by another.
namespace fpkcheck::tests {

/// Trapezoidal rule with n intervals; spectrally accurate for functions that vanish at both ends.
template <class Function>
double trapezoid(const Function& f, double a, double b, int n) {
  const double h = (b - a) / n;
  double sum = (f(a) + f(b)) / 2;
  for (int k = 1; k < n; ++k) sum += f(a + k * h);
  return sum * h;
}

}  // namespace fpkcheck::tests
