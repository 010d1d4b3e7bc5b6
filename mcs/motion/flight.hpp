#pragma once

#include "mcs/motion/free_motion.hpp"
#include "mcs/motion/oscillator.hpp"
#include "mcs/motion/taylor_polynomial.hpp"
#include "numerics/simd/simd.hpp"

namespace fpkcheck::mcs {

/// The free motion between two events: a Taylor polynomial in time, expanded at the initial state,
/// of the solution of paper (1) without impulses. max_step() limits the time to a fraction of the
/// shortest period at the initial energy.
template <class Real>
class BasicFlight {
 public:
  static constexpr int kOrder = kSeriesOrder;

  /// @param oscillator must outlive the flight
  FPKCHECK_INLINE BasicFlight(const Oscillator& oscillator, const BasicState<Real>& start)
      : oscillator_(oscillator), frequency_bound_(frequency_bound(oscillator, start.y, start.v)) {
    a_[0] = start.y;
    a_[1] = start.v;
    compute_taylor_coefficients(oscillator, a_);
  }
  BasicFlight(Oscillator&&, const BasicState<Real>&) = delete;

  /// Longest time for which the polynomial is used: `phase` radians of the highest possible
  /// frequency.
  ///
  /// For phase < pi a flight of this time has at most one impact, and no impact if the flight
  /// starts at the wall with v >= 0. By Sturm's comparison theorem, zeros of a solution of y'' + c
  /// y' + (g(y)/y) y = 0 are at least pi / sqrt(max g(y)/y) apart. So an impact occurs exactly if y
  /// < 0 at the end, and impacts cannot accumulate.
  FPKCHECK_INLINE Real max_step(double phase) const { return phase / frequency_bound_; }

  /// State (y, v) at the time s after the start of the flight.
  FPKCHECK_INLINE BasicState<Real> state_at_time(const Real& s) const {
    return state_at<kOrder>(a_, s);
  }

  /// Second derivative y'' of the polynomial at the time s.
  FPKCHECK_INLINE Real polynomial_acceleration(const Real& s) const {
    return acceleration_at<kOrder>(a_, s);
  }

  /// Acceleration y'' at a state by paper (1).
  FPKCHECK_INLINE Real acceleration(const BasicState<Real>& state) const {
    return -(oscillator_.damping * state.v + restoring_force(oscillator_, state.y));
  }

  /// Zero of y(s) in [0, end], to rounding, in the lanes of `wanted`, where y(0) > 0 > y(end).
  /// Other lanes return a finite number.
  template <class Mask>
  FPKCHECK_INLINE Real impact_time(const Real& end, const BasicState<Real>& at_end,
                                   const Mask& wanted) const {
    Real above{}, below = end;
    Real s = initial_impact_time(end, at_end);
    Mask open = wanted;
    // Halley's method triples the number of correct digits per step; two steps usually suffice.
    for (int iteration = 0; iteration < kMostIterations && simd::any_lane_set(open); ++iteration) {
      const BasicState<Real> state = state_at_time(s);
      const Mask beyond = state.y < 0.0;
      above = simd::select(beyond, above, s);
      below = simd::select(beyond, s, below);
      const Real halley =
          s - state.y * state.v / (state.v * state.v - 0.5 * (state.y * acceleration(state)));
      const Mask inside = (halley >= above) & (halley <= below);
      const Real next = simd::select(inside, halley, 0.5 * (above + below));
      const Real moved = simd::lanewise_max(next - s, s - next);
      s = simd::select(open, next, s);
      // After a third-order correction of 1e-6 the error is rounding.
      open = open & (moved > 1e-6 * end);
    }
    return s;
  }

  /// Time in [0, end] of the maximum of y, v(s) = 0, in the lanes where v(0) > 0 > v(end). The
  /// relative error of about 1e-5 in time causes an error of about 1e-10 in the maximum.
  FPKCHECK_INLINE Real peak_time(const Real& end, const BasicState<Real>& at_end) const {
    const Real chord = end * (a_[1] / (a_[1] - at_end.v));
    const BasicState<Real> state = state_at_time(chord);
    const Real newton = chord - state.v / acceleration(state);
    using Mask = decltype(newton >= 0.0);
    const Mask inside = (newton >= 0.0) & (newton <= end);
    return simd::select(inside, newton, chord);
  }

 private:
  static constexpr int kMostIterations = 60;

  /// First approximation of the impact time: s(0) of the cubic s(y) with the slopes 1/v at both
  /// ends. If this value is outside the interval, the zero of the chord.
  FPKCHECK_INLINE Real initial_impact_time(const Real& end, const BasicState<Real>& at_end) const {
    const Real drop = a_[0] - at_end.y;  // > 0
    const Real u = a_[0] / drop;
    const Real u1 = 1.0 - u;
    const Real s = end * u * u * (3.0 - 2.0 * u) + u * u1 * drop * (u / at_end.v - u1 / a_[1]);
    using Mask = decltype(s > 0.0);
    const Mask inside = (s > 0.0) & (s < end);
    return simd::select(inside, s, end * u);
  }

  const Oscillator& oscillator_;
  Real frequency_bound_;
  TaylorCoefficients<Real> a_;
};

using Flight = BasicFlight<double>;

}  // namespace fpkcheck::mcs
