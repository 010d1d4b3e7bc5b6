#pragma once

#include <array>

#include "mcs/motion/oscillator.hpp"
#include "numerics/simd/simd.hpp"

namespace fpkcheck::mcs {

/// Position y and velocity y' of the oscillator, as numbers or in SIMD lanes
template <class Real>
struct PhaseState {
  Real y;
  Real v;
};
using OscillatorState = PhaseState<double>;

/// Motion of an oscillator between two events, as a Taylor polynomial in time, y(s) = sum_n a_n
/// s^n, expanded at the initial state. Classes derived from TaylorFlight compute a_2, a_3, .. from
/// an equation of motion, and limit the duration of the flight.
template <class Real, int kHighestOrder>
class TaylorFlight {
 public:
  static constexpr int kOrder = kHighestOrder;
  static_assert(kOrder % 2 == 0);

  /// Returns the state (y, v) at the time s after the start of the flight. Horner's rule in s^2,
  /// applied to even and odd powers of the time s separately, halves the chain of dependent
  /// operations.
  FPKCHECK_INLINE PhaseState<Real> state_at_time(const Real& s) const {
    const Real s2 = s * s;
    Real y_even = a_[kOrder], v_odd = double{kOrder} * a_[kOrder];
    Real y_odd{}, v_even{};
#pragma GCC unroll 16
    for (int n = kOrder - 1; n >= 1; n -= 2) {
      y_odd = y_odd * s2 + a_[n];
      v_even = v_even * s2 + static_cast<double>(n) * a_[n];
      y_even = y_even * s2 + a_[n - 1];
      if (n > 1) v_odd = v_odd * s2 + static_cast<double>(n - 1) * a_[n - 1];
    }
    return {y_even + s * y_odd, v_even + s * v_odd};
  }

  FPKCHECK_INLINE Real polynomial_acceleration(const Real& s) const {
    Real sum = double{kOrder * (kOrder - 1)} * a_[kOrder];
#pragma GCC unroll 16
    for (int n = kOrder - 1; n >= 2; --n) sum = sum * s + static_cast<double>(n * (n - 1)) * a_[n];
    return sum;
  }

 protected:
  using Coefficients = std::array<Real, kOrder + 1>;

  FPKCHECK_INLINE TaylorFlight(const SimulatedOscillator& oscillator, const PhaseState<Real>& start)
      : oscillator_(oscillator) {
    a_[0] = start.y;
    a_[1] = start.v;
  }

  const SimulatedOscillator& oscillator_;
  Coefficients a_;
};

// `iterate` and `tolerance` must be always_inline, since files that are compiled for different
// instruction sets call find_bracketed_zero().

/// Returns the zero of a function in the bracket [low, high], in the SIMD lanes of the mask `open`.
/// An iteration of higher order is replaced by bisection if the iteration leaves the bracket. SIMD
/// lanes outside the mask `open` return a finite number.
/// @param s first approximation of the zero, within the bracket
/// @param iterate maps s to the mask of the lanes whose zero is after s, and to the next iterate
/// @param tolerance maps s to the correction below which a SIMD lane has converged
template <class Real, class Mask, class Iterate, class Tolerance>
FPKCHECK_INLINE Real find_bracketed_zero(Real low, Real high, Real s, Mask open,
                                         const Iterate& iterate, const Tolerance& tolerance) {
  constexpr int kMostIterations = 60;
  for (int n = 0; n < kMostIterations && simd::any_mask_lane_set(open); ++n) {
    Mask is_before;
    const Real improved = iterate(s, is_before);
    low = simd::select(is_before, s, low);
    high = simd::select(is_before, high, s);
    const Mask inside = (improved >= low) & (improved <= high);
    const Real next = simd::select(inside, improved, 0.5 * (low + high));
    const Real moved = simd::lanewise_max(next - s, s - next);
    s = simd::select(open, next, s);
    open = open & (moved > tolerance(s));
  }
  return s;
}

}  // namespace fpkcheck::mcs
