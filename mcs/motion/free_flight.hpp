#pragma once

#include "mcs/motion/taylor_flight.hpp"

// free_flight.hpp is compiled for several instruction sets.
namespace fpkcheck::mcs {
namespace {

/// Free flight in which the velocity changes sign at most once, between walls at any positions.
template <class Real, int kOrder>
class FreeFlight : public TaylorFlight<Real, kOrder> {
  using Base = TaylorFlight<Real, kOrder>;

 public:
  using Base::polynomial_acceleration;
  using Base::state_at_time;

  /// Makes the flight polynomial constant in the SIMD lanes of the mask `in_contact`.
  template <class Mask>
  FPKCHECK_INLINE void hold_mass_at_initial_position(const Mask& in_contact) {
#pragma GCC unroll 16
    for (int n = 1; n <= kOrder; ++n) a_[n] = simd::select(in_contact, Real{}, a_[n]);
  }

  /// Returns the turning time in [0, end], the zero of the velocity, in the SIMD lanes where v(0)
  /// and v(end) have different signs. The relative error 1e-6 of the turning time causes an error
  /// of 1e-12 in the displacement.
  template <class Mask>
  FPKCHECK_INLINE Real turning_time(const Real& end, const PhaseState<Real>& at_end,
                                    const Mask& wanted) const {
    const auto newton = [&](const Real& s, Mask& is_before) __attribute__((always_inline)) {
      const Real v = state_at_time(s).v;
      is_before = v * a_[1] > 0.0;
      return s - v / polynomial_acceleration(s);
    };
    const Real chord = end * (a_[1] / (a_[1] - simd::select(wanted, at_end.v, -a_[1] - 1.0)));
    return find_bracketed_zero(
        Real{}, end, chord, wanted, newton,
        [](const Real& s) __attribute__((always_inline)) { return 1e-4 * s; });
  }

  /// Returns the impact time in [low, high], the zero of y(s) - wall up to rounding, in the SIMD
  /// lanes of the mask `wanted`, where `inside` * (y - wall) changes from positive to negative.
  /// @param guess first approximation of the impact time, within [low, high]
  template <class Mask>
  FPKCHECK_INLINE Real impact_time(const Real& wall, const Real& inside, const Real& low,
                                   const Real& high, const Real& guess, const Mask& wanted) const {
    const auto halley = [&](const Real& s, Mask& is_before) __attribute__((always_inline)) {
      const PhaseState<Real> state = state_at_time(s);
      const Real distance = inside * (state.y - wall), speed = inside * state.v;
      is_before = distance > 0.0;
      return s - distance * speed /
                     (speed * speed - 0.5 * (distance * (inside * polynomial_acceleration(s))));
    };
    // After a correction of relative size 1e-6, Halley's third-order method is exact up to
    // rounding.
    return find_bracketed_zero(
        low, high, guess, wanted, halley,
        [](const Real& s) __attribute__((always_inline)) { return 1e-6 * s; });
  }

 protected:
  using Base::a_;
  using Base::Base;
};

}  // namespace
}  // namespace fpkcheck::mcs
