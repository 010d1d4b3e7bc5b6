#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

/// Numbers in lanes: `W` doubles that go through the same arithmetic side by side, one trajectory a
/// lane. They are GCC's (and clang's) vector types, which the compiler lowers to whatever
/// instructions the function they are used in may use (see instruction_set.hpp).
///
/// A lane's bits do not depend on W nor on the instructions: +, -, *, / and sqrt are rounded
/// correctly by all of them, nothing is contracted (-ffp-contract=off), and nothing here mixes
/// lanes.
namespace fpkcheck::simd {

/// What is inlined always: packs of lanes must not be passed between functions that are compiled
/// for different instructions.
#define FPKCHECK_INLINE inline __attribute__((always_inline))

template <int W>
struct LanesOf {
  static_assert(std::has_single_bit(static_cast<unsigned>(W)));
  // In this form: GCC 12 ignores the attribute in `using` where W is a parameter.
  typedef double Real __attribute__((vector_size(8 * W)));
  typedef std::int64_t Mask __attribute__((vector_size(8 * W)));  // 0 or -1
  typedef std::int64_t Bits __attribute__((vector_size(8 * W)));  // of the doubles
  typedef std::int32_t Index __attribute__((vector_size(4 * W)));
};
template <>
struct LanesOf<1> {
  using Real = double;
  using Mask = bool;
  using Bits = std::int64_t;
  using Index = std::int32_t;
};

template <class Real>
inline constexpr int kWidth = static_cast<int>(sizeof(Real) / sizeof(double));

FPKCHECK_INLINE double square_root(double x) { return std::sqrt(x); }
template <class Real>
FPKCHECK_INLINE Real square_root(const Real& x) {
  Real root{};
#pragma GCC unroll 16
  for (int i = 0; i < kWidth<Real>; ++i) root[i] = __builtin_sqrt(x[i]);
  return root;
}

/// a where the mask is set, else b.
FPKCHECK_INLINE double select(bool mask, double a, double b) { return mask ? a : b; }
template <class Mask, class Real>
FPKCHECK_INLINE Real select(const Mask& mask, const Real& a, const Real& b) {
  // In bits: GCC 12 turns `mask ? a : b` into a branch for every lane.
  return (Real)((mask & (Mask)a) | (~mask & (Mask)b));
}
/// a where the mask is set, else 0.
FPKCHECK_INLINE double where(bool mask, double a) { return mask ? a : 0; }
template <class Mask, class Real>
FPKCHECK_INLINE Real where(const Mask& mask, const Real& a) {
  return (Real)(mask & (Mask)a);
}

template <class Real>
FPKCHECK_INLINE Real smaller(const Real& a, const Real& b) {
  return a < b ? a : b;
}
template <class Real>
FPKCHECK_INLINE Real larger(const Real& a, const Real& b) {
  return a > b ? a : b;
}

FPKCHECK_INLINE bool any(bool mask) { return mask; }
FPKCHECK_INLINE bool any(int mask) { return mask != 0; }  // bool & bool
template <class Mask>
FPKCHECK_INLINE bool any(const Mask& mask) {
  typedef std::int64_t Pair __attribute__((vector_size(16)));
  constexpr int kPairs = static_cast<int>(sizeof(Mask) / sizeof(Pair));
  Pair pairs[kPairs];
  __builtin_memcpy(pairs, &mask, sizeof mask);
#pragma GCC unroll 16
  for (int i = 1; i < kPairs; ++i) pairs[0] |= pairs[i];
  return (pairs[0][0] | pairs[0][1]) != 0;
}

/// The number in all lanes.
template <class Real>
FPKCHECK_INLINE Real all_lanes(double x) {
  return Real{} + x;
}

FPKCHECK_INLINE double lane(double x, int) { return x; }
FPKCHECK_INLINE double lane(bool x, int) { return x ? 1 : 0; }
template <class Real>
FPKCHECK_INLINE double lane(const Real& x, int i) {
  return static_cast<double>(x[i]);
}

template <class Real>
FPKCHECK_INLINE Real load(const double* from) {
  Real x;
  __builtin_memcpy(&x, from, sizeof(Real));
  return x;
}
template <class Real>
FPKCHECK_INLINE void store(const Real& x, double* to) {
  __builtin_memcpy(to, &x, sizeof(Real));
}

/// Numbers 0 .. 2^31 - 1 with their fraction cut off.
FPKCHECK_INLINE std::int32_t truncated(double x) { return static_cast<std::int32_t>(x); }
template <class Real>
FPKCHECK_INLINE typename LanesOf<kWidth<Real>>::Index truncated(const Real& x) {
  return __builtin_convertvector(x, typename LanesOf<kWidth<Real>>::Index);
}

}  // namespace fpkcheck::simd
