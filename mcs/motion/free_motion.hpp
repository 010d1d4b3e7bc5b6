#pragma once

#include <array>

#include "mcs/motion/oscillator.hpp"
#include "numerics/simd/elementary.hpp"
#include "numerics/simd/simd.hpp"

/// Taylor coefficients of the free motion, paper (1) without impulses: y'' = -(c y' + g(y)), y >=
/// 0. Each function has closed formulas for the paper's spring, g(y) = k y + mu y^3. For other
/// springs the functions loop over the powers of y instead of having a formula for each degree,
/// which keeps the compile time short.
namespace fpkcheck::mcs {

inline constexpr int kSeriesOrder = 12;

/// Coefficients a_n of y(s) = sum_n a_n s^n.
template <class Real>
using TaylorCoefficients = std::array<Real, kSeriesOrder + 1>;

/// Polynomial sum_n p_n y^n by Horner's rule, n up to `degree`.
template <class Real>
FPKCHECK_INLINE Real horner(const numerics::Polynomial& p, int degree, const Real& y) {
  Real sum{};
  for (int n = degree; n >= 0; --n) sum = sum * y + p.coefficient(static_cast<std::size_t>(n));
  return sum;
}

/// Spring force g(y).
template <class Real>
FPKCHECK_INLINE Real restoring_force(const Oscillator& oscillator, const Real& y) {
  if (oscillator.is_duffing) return y * (oscillator.stiffness + oscillator.cubic * (y * y));
  return horner(oscillator.force, oscillator.degree, y);
}

template <class Real>
FPKCHECK_INLINE void compute_duffing_coefficients(const Oscillator& oscillator,
                                                  TaylorCoefficients<Real>& a) {
  const double c = oscillator.damping, k = oscillator.stiffness, mu = oscillator.cubic;
  std::array<Real, kSeriesOrder - 1> square;  // [y^2]_n
  // Each sum adds the newest coefficients last, so that the chain of dependent operations is short.
#pragma GCC unroll 16
  for (int n = 0; n + 2 <= kSeriesOrder; ++n) {
    Real pairs{};
#pragma GCC unroll 16
    for (int i = (n + 1) / 2 - 1; i >= 0; --i) pairs = pairs + a[i] * a[n - i];
    square[n] = n % 2 == 0 ? 2.0 * pairs + a[n / 2] * a[n / 2] : 2.0 * pairs;
    Real cube{};
#pragma GCC unroll 16
    for (int i = 1; i < n; ++i) cube = cube + square[i] * a[n - i];
    if (n > 0) cube = cube + square[0] * a[n];
    cube = cube + square[n] * a[0];
    a[n + 2] = (k * a[n] + mu * cube + (c * (n + 1)) * a[n + 1]) * (-1.0 / ((n + 1) * (n + 2)));
  }
}

template <class Real>
FPKCHECK_INLINE void compute_polynomial_force_coefficients(const Oscillator& oscillator,
                                                           TaylorCoefficients<Real>& a) {
  const auto g = [&](int d) { return oscillator.force.coefficient(static_cast<std::size_t>(d)); };
  Real powers[Oscillator::kHighestDegree + 1][kSeriesOrder + 1];  // [y^d]_n
  powers[1][0] = a[0];
  powers[1][1] = a[1];
  for (int n = 0; n + 2 <= kSeriesOrder; ++n) {
    Real force = g(1) * powers[1][n];
    for (int d = 2; d <= oscillator.degree; ++d) {
      Real sum{};
      for (int i = 0; i <= n; ++i) sum = sum + powers[d - 1][i] * powers[1][n - i];
      powers[d][n] = sum;
      force = force + g(d) * sum;
    }
    powers[1][n + 2] =
        (force + (oscillator.damping * (n + 1)) * powers[1][n + 1]) * (-1.0 / ((n + 1) * (n + 2)));
  }
#pragma GCC unroll 16
  for (int n = 2; n <= kSeriesOrder; ++n) a[n] = powers[1][n];
}

/// Computes a_2, a_3, .. from a_0 and a_1,
///
///     (n+1)(n+2) a_{n+2} = -(c (n+1) a_{n+1} + sum_d g_d [y^d]_n).
///
/// Cauchy products give the coefficients [y^d]_n of the powers in the spring force.
template <class Real>
FPKCHECK_INLINE void compute_taylor_coefficients(const Oscillator& oscillator,
                                                 TaylorCoefficients<Real>& a) {
  if (oscillator.is_duffing) {
    compute_duffing_coefficients(oscillator, a);
  } else {
    compute_polynomial_force_coefficients(oscillator, a);
  }
}

/// Upper bound of the frequency: square root of the largest slope of the spring at the energy E =
/// y'^2/2 + U(y), plus c. The bound holds for the whole flight, since the energy does not grow. The
/// time step stays below the pole that limits the convergence of the Taylor series of a hardening
/// spring.
template <class Real>
FPKCHECK_INLINE Real frequency_bound(const Oscillator& o, const Real& y, const Real& v) {
  if (o.is_duffing) {
    // k + 3 mu y^2 with mu y^4 / 4 <= E
    const double k = o.stiffness, mu = o.cubic;
    const Real y2 = y * y;
    const Real energy = 0.5 * (v * v) + y2 * (k / 2 + (mu / 4) * y2);
    return simd::square_root(k + 6.0 * simd::square_root(mu * energy)) + o.damping;
  }
  constexpr double kSmallest = 1e-290;  // smallest argument of the logarithm
  const Real energy = 0.5 * (v * v) + horner(o.potential, o.degree + 1, y);
  const Real power =
      simd::lanewise_max(energy / o.potential_bound, simd::broadcast<Real>(kSmallest));
  const Real largest_y = simd::exponential(simd::logarithm(power) / (o.degree + 1.0));
  return simd::square_root(horner(o.slope_bound, o.degree - 1, largest_y)) + o.damping;
}

}  // namespace fpkcheck::mcs
