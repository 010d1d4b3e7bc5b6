#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

/// SIMD types of `W` doubles, one trajectory in each lane. They are vector types of GCC and Clang,
/// which the compiler lowers to the instruction set of the calling function (see
/// instruction_set.hpp).
///
/// The bits of a lane depend neither on W nor on the instruction set: +, -, *, / and sqrt are
/// correctly rounded, nothing is contracted (-ffp-contract=off), and no operation here mixes lanes.
namespace fpkcheck::simd {

/// Always inlined: SIMD vectors must not be passed between functions that are compiled for
/// different instruction sets.
#define FPKCHECK_INLINE inline __attribute__((always_inline))

template <int W>
struct VectorTypes {
  static_assert(std::has_single_bit(static_cast<unsigned>(W)));
  // A typedef, since GCC 12 ignores the attribute in `using` where W is a parameter.
  typedef double Real __attribute__((vector_size(8 * W)));
  typedef std::int64_t Mask __attribute__((vector_size(8 * W)));  // 0 or -1
  typedef std::int64_t Bits __attribute__((vector_size(8 * W)));  // bit pattern of the doubles
  typedef std::int32_t Index __attribute__((vector_size(4 * W)));
};
template <>
struct VectorTypes<1> {
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
  // Bitwise: GCC 12 compiles `mask ? a : b` to a branch for every lane.
  return (Real)((mask & (Mask)a) | (~mask & (Mask)b));
}
/// a where the mask is set, else 0.
FPKCHECK_INLINE double where(bool mask, double a) { return mask ? a : 0; }
template <class Mask, class Real>
FPKCHECK_INLINE Real where(const Mask& mask, const Real& a) {
  return (Real)(mask & (Mask)a);
}

template <class Real>
FPKCHECK_INLINE Real lanewise_min(const Real& a, const Real& b) {
  return a < b ? a : b;
}
template <class Real>
FPKCHECK_INLINE Real lanewise_max(const Real& a, const Real& b) {
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

/// Broadcasts a number to all lanes.
template <class Real>
FPKCHECK_INLINE Real broadcast(double x) {
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

/// Truncates numbers in 0 .. 2^31 - 1 to integers.
FPKCHECK_INLINE std::int32_t truncate_to_index(double x) { return static_cast<std::int32_t>(x); }
template <class Real>
FPKCHECK_INLINE typename VectorTypes<kWidth<Real>>::Index truncate_to_index(const Real& x) {
  return __builtin_convertvector(x, typename VectorTypes<kWidth<Real>>::Index);
}

}  // namespace fpkcheck::simd
