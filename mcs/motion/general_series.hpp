#pragma once

#include <array>

#include "mcs/motion/general_oscillator.hpp"
#include "numerics/simd/elementary.hpp"
#include "numerics/simd/simd.hpp"

// Included by files that are compiled for different instruction sets, as motion/advance_simd.hpp.
namespace fpkcheck::mcs {
namespace {

/// Coefficients a_n of y(s) = sum_n a_n s^n.
template <class Real, int kOrder>
using GeneralTaylorCoefficients = std::array<Real, kOrder + 1>;

template <class Real>
FPKCHECK_INLINE Real general_force(const GeneralOscillator& o, const Real& y) {
  Real sum = simd::broadcast<Real>(o.force[5]);
  for (std::size_t n = 5; n-- > 0;) sum = sum * y + o.force[n];
  return sum;
}

template <class Real>
FPKCHECK_INLINE Real general_stiffness(const GeneralOscillator& o, const Real& y) {
  Real sum = simd::broadcast<Real>(5 * o.force[5]);
  for (std::size_t n = 4; n > 0; --n) sum = sum * y + static_cast<double>(n) * o.force[n];
  return sum;
}

/// Coefficient n of the product of two series, [a b]_n.
template <class A, class B>
FPKCHECK_INLINE auto cauchy_product(const A& a, const B& b, int n) {
  auto sum = a[0] * b[n];
#pragma GCC unroll 16
  for (int i = 1; i <= n; ++i) sum = sum + a[i] * b[n - i];
  return sum;
}

/// Computes a_2, a_3, .. from a_0 and a_1,
///
///     (n+1)(n+2) a_{n+2} = -([g(y)]_n + (n+1) [C(y)]_{n+1} + c_vv [v^3]_n),    C' = c.
///
/// Cauchy products give the coefficients of powers; c(y) v = dC(y)/ds.
template <GeneralOscillator::Kind kKind, int kOrder, class Real>
FPKCHECK_INLINE void compute_general_coefficients_inline(
    const GeneralOscillator& o, GeneralTaylorCoefficients<Real, kOrder>& a) {
  using Kind = GeneralOscillator::Kind;
  const double c0 = o.damping[0], c1 = o.damping[1] / 2, c2 = o.damping[2] / 3;
  std::array<Real, kOrder + 1> y2, y3, y4, y5, v, v2;
  if constexpr (kKind != Kind::linear) {
    y2[0] = a[0] * a[0];
    y3[0] = y2[0] * a[0];
  }
#pragma GCC unroll 16
  for (int n = 0; n + 2 <= kOrder; ++n) {
    Real sum = o.force[1] * a[n] + (c0 * (n + 1)) * a[n + 1];
    if (n == 0) sum = sum + o.force[0];
    if constexpr (kKind != Kind::linear) {
      y2[n + 1] = cauchy_product(a, a, n + 1);
      y3[n + 1] = cauchy_product(a, y2, n + 1);
      sum = sum + o.force[2] * y2[n] + o.force[3] * y3[n] +
            static_cast<double>(n + 1) * (c1 * y2[n + 1] + c2 * y3[n + 1]);
    }
    if constexpr (kKind == Kind::full) {
      y4[n] = cauchy_product(y2, y2, n);
      y5[n] = cauchy_product(y2, y3, n);
      v[n] = static_cast<double>(n + 1) * a[n + 1];
      v2[n] = cauchy_product(v, v, n);
      sum = sum + o.force[4] * y4[n] + o.force[5] * y5[n] + o.rayleigh * cauchy_product(v2, v, n);
    }
    a[n + 2] = sum * (-1.0 / ((n + 1) * (n + 2)));
  }
}

// The function is not inlined, since the compiler would otherwise generate a copy for each call.
template <GeneralOscillator::Kind kKind, int kOrder, class Real>
__attribute__((noinline)) void compute_general_coefficients_of_kind(
    const GeneralOscillator& o, GeneralTaylorCoefficients<Real, kOrder>& a) {
  compute_general_coefficients_inline<kKind, kOrder>(o, a);
}

template <int kOrder, class Real>
FPKCHECK_INLINE void compute_general_coefficients(const GeneralOscillator& o,
                                                  GeneralTaylorCoefficients<Real, kOrder>& a) {
  using Kind = GeneralOscillator::Kind;
  switch (o.kind) {
    case Kind::linear:
      return compute_general_coefficients_of_kind<Kind::linear, kOrder, Real>(o, a);
    case Kind::cubic:
      return compute_general_coefficients_of_kind<Kind::cubic, kOrder, Real>(o, a);
    case Kind::full:
      return compute_general_coefficients_of_kind<Kind::full, kOrder, Real>(o, a);
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
