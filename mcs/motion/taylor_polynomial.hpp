#pragma once

#include <array>

#include "numerics/simd/simd.hpp"

namespace fpkcheck::mcs {

/// Position y and velocity y' of the oscillator, as numbers or in SIMD lanes.
template <class Real>
struct BasicState {
  Real y;
  Real v;
};
using State = BasicState<double>;

/// State (y, y') at the time s of the polynomial y(s) = sum_n a_n s^n. Horner's rule in s^2,
/// applied to even and odd powers separately, halves the chain of dependent operations.
template <int kOrder, class Real>
FPKCHECK_INLINE BasicState<Real> state_at(const std::array<Real, kOrder + 1>& a, const Real& s) {
  static_assert(kOrder % 2 == 0);
  const Real s2 = s * s;
  Real y_even = a[kOrder], v_odd = double{kOrder} * a[kOrder];
  Real y_odd{}, v_even{};
#pragma GCC unroll 16
  for (int n = kOrder - 1; n >= 1; n -= 2) {
    y_odd = y_odd * s2 + a[n];
    v_even = v_even * s2 + static_cast<double>(n) * a[n];
    y_even = y_even * s2 + a[n - 1];
    if (n > 1) v_odd = v_odd * s2 + static_cast<double>(n - 1) * a[n - 1];
  }
  return {y_even + s * y_odd, v_even + s * v_odd};
}

/// Second derivative y''(s) of the polynomial y(s) = sum_n a_n s^n.
template <int kOrder, class Real>
FPKCHECK_INLINE Real acceleration_at(const std::array<Real, kOrder + 1>& a, const Real& s) {
  Real sum = double{kOrder * (kOrder - 1)} * a[kOrder];
#pragma GCC unroll 16
  for (int n = kOrder - 1; n >= 2; --n) sum = sum * s + static_cast<double>(n * (n - 1)) * a[n];
  return sum;
}

}  // namespace fpkcheck::mcs
