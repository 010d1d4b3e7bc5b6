#pragma once

/// Quadrature for tests, independent of the quadrature rules of the solvers.
namespace fpkcheck::tests {

/// Trapezoidal rule with n intervals; spectrally accurate for smooth functions that vanish at both
/// ends.
template <class Function>
double trapezoid(const Function& f, double a, double b, int n) {
  const double h = (b - a) / n;
  double sum = (f(a) + f(b)) / 2;
  for (int k = 1; k < n; ++k) sum += f(a + k * h);
  return sum * h;
}

}  // namespace fpkcheck::tests
