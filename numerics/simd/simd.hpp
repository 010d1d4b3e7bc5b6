#pragma once

#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>

/// SIMD vectors of `W` doubles, with one trajectory in each lane, in the vector extension of GCC
/// and Clang. The compiler translates vector operations to the instruction set of the calling
/// function (see instruction_set.hpp).
///
/// The results in a SIMD lane are bit-identical for all vector widths W and all instruction sets.
/// In SIMD vectors, the operations +, -, *, / and sqrt are correctly rounded, and -ffp-contract=off
/// prevents fused multiply-add. No operation of simd.hpp combines numbers of different lanes.
namespace fpkcheck::simd {

/// Attribute that forces inlining of a function, since SIMD vectors must not be passed between
/// functions that are compiled for different instruction sets.
#define FPKCHECK_INLINE inline __attribute__((always_inline))

template <int W>
struct SimdVectorTypes {
  static_assert(std::has_single_bit(static_cast<unsigned>(W)));
  // The vector types are typedefs, since GCC 12 ignores the vector attribute in a `using`
  // declaration if W is a template parameter.
  typedef double Real __attribute__((vector_size(8 * W)));
  typedef std::int64_t Mask __attribute__((vector_size(8 * W)));  // each lane is 0 or -1
  typedef std::int64_t Bits __attribute__((vector_size(8 * W)));  // bit pattern of the doubles
  typedef std::int32_t Index __attribute__((vector_size(4 * W)));
};
template <>
struct SimdVectorTypes<1> {
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

/// Returns a SIMD vector that has the number of `a` in each lane with a set mask, and the number of
/// `b` in all other lanes.
FPKCHECK_INLINE double select(bool mask, double a, double b) { return mask ? a : b; }
template <class Mask, class Real>
FPKCHECK_INLINE Real select(const Mask& mask, const Real& a, const Real& b) {
  // The selection uses bitwise operations, since GCC 12 compiles `mask ? a : b` to a branch for
  // every lane.
  return (Real)((mask & (Mask)a) | (~mask & (Mask)b));
}
/// Returns a SIMD vector that has the number of `a` in each lane with a set mask, and 0 in all
/// other lanes.
FPKCHECK_INLINE double select_or_zero(bool mask, double a) { return mask ? a : 0; }
template <class Mask, class Real>
FPKCHECK_INLINE Real select_or_zero(const Mask& mask, const Real& a) {
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

FPKCHECK_INLINE bool any_mask_lane_set(bool mask) { return mask; }
FPKCHECK_INLINE bool any_mask_lane_set(int mask) {
  return mask != 0;
}  // the type of bool & bool is int
template <class Mask>
FPKCHECK_INLINE bool any_mask_lane_set(const Mask& mask) {
  typedef std::int64_t Pair __attribute__((vector_size(16)));
  constexpr int kPairs = static_cast<int>(sizeof(Mask) / sizeof(Pair));
  Pair pairs[kPairs];
  __builtin_memcpy(pairs, &mask, sizeof mask);
#pragma GCC unroll 16
  for (int i = 1; i < kPairs; ++i) pairs[0] |= pairs[i];
  return (pairs[0][0] | pairs[0][1]) != 0;
}

template <class Real>
FPKCHECK_INLINE Real all_lanes_equal_to(double x) {
  return Real{} + x;
}

FPKCHECK_INLINE double value_in_lane(double x, int) { return x; }
FPKCHECK_INLINE double value_in_lane(bool x, int) { return x ? 1 : 0; }
template <class Real>
FPKCHECK_INLINE double value_in_lane(const Real& x, int i) {
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

/// Truncates each number of a SIMD vector to an integer.
/// @pre the numbers are in 0 .. 2^31 - 1
FPKCHECK_INLINE std::int32_t truncate_to_index(double x) {
  assert(x >= 0 && x < 0x1p31);
  return static_cast<std::int32_t>(x);
}
template <class Real>
FPKCHECK_INLINE typename SimdVectorTypes<kWidth<Real>>::Index truncate_to_index(const Real& x) {
  return __builtin_convertvector(x, typename SimdVectorTypes<kWidth<Real>>::Index);
}

}  // namespace fpkcheck::simd
