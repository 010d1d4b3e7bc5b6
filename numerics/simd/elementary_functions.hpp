#pragma once

#include <cstdint>

#include "numerics/simd/simd.hpp"

/// Logarithm, exponential and sine functions that use only the operations +, -, * and /. Correct
/// rounding of +, -, * and / makes the results bit-identical for all compilers, libraries, SIMD
/// widths and instruction sets.
namespace fpkcheck::simd {

/// The number 2^52 + 2^51. For a small integer n, the last bits of 2^52 + 2^51 + n are the bits of
/// n.
inline constexpr double kShift = 6755399441055744.0;
inline constexpr std::int64_t kShiftBits = 0x4338000000000000;
/// The number ln 2 as the sum kLn2High + kLn2Low. The product of kLn2High and a binary exponent is
/// exact, since the last bits of kLn2High are zero.
inline constexpr double kLn2High = 6.93147180369123816490e-01, kLn2Low = 1.90821492927058770002e-10;

/// Computes the natural logarithm of a normalised number x > 0 with an error of at most 1 unit in
/// the last place. With x = 2^n m, sqrt(1/2) <= m < sqrt 2 and s = (m - 1)/(m + 1), log x is n ln 2
/// + 2 artanh s.
template <class Real>
FPKCHECK_INLINE Real logarithm(const Real& x) {
  using Bits = typename SimdVectorTypes<kWidth<Real>>::Bits;
  constexpr std::int64_t kHalfRoot = 0x3fe6a09e667f3bcd;  // bits of sqrt(1/2)
  Bits bits;
  __builtin_memcpy(&bits, &x, sizeof bits);
  const Bits exponent = (bits - kHalfRoot) >> 52;  // binary exponent n of x
  const Bits fraction_bits = bits - (exponent << 52);
  Real m;
  __builtin_memcpy(&m, &fraction_bits, sizeof m);
  // Bits of a double whose last bits are the binary exponent n of a number.
  const Bits shifted = exponent + kShiftBits;
  Real n;
  __builtin_memcpy(&n, &shifted, sizeof n);
  n = n - kShift;
  const Real f = m - 1.0;
  const Real s = f / (2.0 + f);
  const Real z = s * s;
  Real series = Real{} + 1.0 / 21;
#pragma GCC unroll 16
  for (int k = 19; k >= 3; k -= 2) series = series * z + 1.0 / k;
  return n * kLn2High + (2.0 * s + (2.0 * s * (z * series) + n * kLn2Low));
}

/// Computes exp x for |x| <= 700 with an error of about 1 unit in the last place. With x = n ln 2 +
/// r and |r| <= ln(2)/2, exp x is 2^n times the Taylor series of exp r up to r^13.
template <class Real>
FPKCHECK_INLINE Real exponential(const Real& x) {
  using Bits = typename SimdVectorTypes<kWidth<Real>>::Bits;
  constexpr double kPerLn2 = 1.4426950408889634074;
  const Real shifted = x * kPerLn2 + kShift;
  const Real n = shifted - kShift;
  const Real r = (x - n * kLn2High) - n * kLn2Low;
  // Horner's rule for even and odd powers separately halves the chain of dependent operations.
  constexpr double kReciprocalFactorials[] = {1.0,
                                              1.0,
                                              1.0 / 2,
                                              1.0 / 6,
                                              1.0 / 24,
                                              1.0 / 120,
                                              1.0 / 720,
                                              1.0 / 5040,
                                              1.0 / 40320,
                                              1.0 / 362880,
                                              1.0 / 3628800,
                                              1.0 / 39916800,
                                              1.0 / 479001600,
                                              1.0 / 6227020800};
  const Real r2 = r * r;
  Real even = Real{} + kReciprocalFactorials[12], odd = Real{} + kReciprocalFactorials[13];
#pragma GCC unroll 16
  for (int k = 10; k >= 0; k -= 2) {
    even = even * r2 + kReciprocalFactorials[k];
    odd = odd * r2 + kReciprocalFactorials[k + 1];
  }
  Real series = even + r * odd;
  // Adding n to the exponent bits of the Taylor series of exp r multiplies the series by 2^n.
  Bits bits, exponent;
  __builtin_memcpy(&bits, &series, sizeof bits);
  __builtin_memcpy(&exponent, &shifted, sizeof exponent);
  bits = bits + ((exponent - kShiftBits) << 52);
  __builtin_memcpy(&series, &bits, sizeof series);
  return series;
}

/// Computes sin(pi t / 2) for -1 <= t <= 1 with an error of at most 5e-16, by the Taylor series up
/// to t^21.
template <class Real>
FPKCHECK_INLINE Real sine_of_quarter_turns(const Real& t) {
  // Taylor coefficients (-1)^k (pi/2)^(2k+1) / (2k+1)!
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

}  // namespace fpkcheck::simd
