#pragma once

#include <cstdint>

#include "mcs/lanes.hpp"

/// Logarithm and sine from +, -, *, / alone, so that they give the same bits with any compiler,
/// library, width and instructions.
namespace fpkcheck::mcs {

/// log x for normal x > 0, to 1 unit in the last place: x = 2^n m, sqrt(1/2) <= m < sqrt 2,
/// log m = 2 artanh s, s = (m - 1)/(m + 1).
template <class Real>
FPKCHECK_INLINE Real logarithm(const Real& x) {
  using Mask = typename LanesOf<kWidth<Real>>::Mask;
  constexpr std::int64_t kHalfRoot = 0x3fe6a09e667f3bcd;  // sqrt(1/2)
  Mask bits;
  __builtin_memcpy(&bits, &x, sizeof bits);
  const Mask exponent = (bits - kHalfRoot) >> 52;  // n
  const Mask fraction_bits = bits - (exponent << 52);
  Real m;
  __builtin_memcpy(&m, &fraction_bits, sizeof m);
  // n as a double: 2^52 + 2^51 + n has n in its last bits.
  constexpr double kShift = 6755399441055744.0;
  const Mask shifted = exponent + 0x4338000000000000;
  Real n;
  __builtin_memcpy(&n, &shifted, sizeof n);
  n = n - kShift;
  const Real f = m - 1.0;
  const Real s = f / (2.0 + f);
  const Real z = s * s;
  Real series = Real{} + 1.0 / 21;
#pragma GCC unroll 16
  for (int k = 19; k >= 3; k -= 2) series = series * z + 1.0 / k;
  // ln 2 in two parts, the first with zeros at the end: n times it is exact.
  constexpr double kLn2High = 6.93147180369123816490e-01, kLn2Low = 1.90821492927058770002e-10;
  return n * kLn2High + (2.0 * s + (2.0 * s * (z * series) + n * kLn2Low));
}

/// sin(pi t / 2) for -1 <= t <= 1, to 5e-16: Taylor's series up to t^21.
template <class Real>
FPKCHECK_INLINE Real sine_of_quarter_turns(const Real& t) {
  // (-1)^k (pi/2)^(2k+1) / (2k+1)!
  constexpr double kCoefficients[] = {
      1.5707963267948965580e+00,  -6.4596409750624628199e-01, 7.9692626246167047599e-02,
      -4.6817541353186883230e-03, 1.6044118478735982939e-04,  -3.5988432352120851779e-06,
      5.6921729219679266811e-08,  -6.6880351098114676795e-10, 6.0669357311061955346e-12,
      -4.3770654673137422631e-14, 2.5714228928604740866e-16};
  const Real z = t * t;
  Real series = Real{} + kCoefficients[10];
#pragma GCC unroll 16
  for (int k = 9; k >= 0; --k) series = series * z + kCoefficients[k];
  return series * t;
}

}  // namespace fpkcheck::mcs
