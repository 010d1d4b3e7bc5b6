#pragma once

#include "mcs/motion/taylor_flight.hpp"

namespace fpkcheck::mcs {

/// Free flight of a hardening Duffing oscillator (SimulatedOscillator::Kind::duffing_at_wall),
/// paper (1) without impulses: y'' = -(c y' + k y + mu y^3) with c, k, mu >= 0, in y >= 0. The
/// initial energy of a DuffingFlight bounds the frequency during the flight, since the energy does
/// not grow between impulses.
template <class Real>
class DuffingFlight : public TaylorFlight<Real, 12> {
  using Base = TaylorFlight<Real, 12>;
  using Base::a_;
  using Base::oscillator_;

 public:
  using Base::kOrder;
  using Base::state_at_time;

  /// @param oscillator must outlive the flight
  FPKCHECK_INLINE DuffingFlight(const SimulatedOscillator& oscillator,
                                const PhaseState<Real>& start)
      : Base(oscillator, start), frequency_bound_(frequency_bound(oscillator, start)) {
    compute_taylor_coefficients();
  }
  DuffingFlight(SimulatedOscillator&&, const PhaseState<Real>&) = delete;

  /// Returns the longest duration of a DuffingFlight, `phase` radians at the frequency bound.
  ///
  /// By Sturm's comparison theorem, the zeros of a solution y(t) of y'' + c y' + (g(y)/y) y = 0
  /// have distances of at least pi / sqrt(max g(y)/y). If `phase` is below pi, a flight therefore
  /// has at most one impact, and no impact if the flight starts at the wall with v >= 0. An impact
  /// occurs if and only if y < 0 at the end of the flight polynomial, and impacts cannot
  /// accumulate.
  FPKCHECK_INLINE Real max_flight_duration(double phase) const { return phase / frequency_bound_; }

  FPKCHECK_INLINE Real acceleration(const PhaseState<Real>& state) const {
    const double c = oscillator_.damping[0], k = oscillator_.force[1], mu = oscillator_.force[3];
    const Real force = state.y * (k + mu * (state.y * state.y));
    return -(c * state.v + force);
  }

  /// Returns the impact time in [0, end], the zero of y(s) up to rounding, in the SIMD lanes of the
  /// mask `wanted`, where y(0) > 0 > y(end). SIMD lanes outside the mask `wanted` return a finite
  /// number.
  template <class Mask>
  FPKCHECK_INLINE Real impact_time(const Real& end, const PhaseState<Real>& at_end,
                                   const Mask& wanted) const {
    // Halley's method triples the number of correct digits of the impact time per iteration, so
    // that two iterations usually suffice.
    const auto halley = [&](const Real& s, Mask& is_before) __attribute__((always_inline)) {
      const PhaseState<Real> state = state_at_time(s);
      is_before = state.y >= 0.0;
      return s - state.y * state.v / (state.v * state.v - 0.5 * (state.y * acceleration(state)));
    };
    // After a correction of relative size 1e-6, Halley's third-order method is exact up to
    // rounding.
    return find_bracketed_zero(
        Real{}, end, impact_time_guess(end, at_end), wanted,
        halley, [&](const Real&) __attribute__((always_inline)) { return 1e-6 * end; });
  }

  /// Returns the time s in [0, end] of the maximum of y, where v(s) = 0, in the SIMD lanes with
  /// v(0) > 0 > v(end). A relative error of about 1e-5 in the time of the maximum causes an error
  /// of about 1e-10 in the maximum of y.
  FPKCHECK_INLINE Real displacement_peak_time(const Real& end,
                                              const PhaseState<Real>& at_end) const {
    const Real chord = end * (a_[1] / (a_[1] - at_end.v));
    const PhaseState<Real> state = state_at_time(chord);
    const Real newton = chord - state.v / acceleration(state);
    using Mask = decltype(newton >= 0.0);
    const Mask inside = (newton >= 0.0) & (newton <= end);
    return simd::select(inside, newton, chord);
  }

 private:
  /// Returns an upper bound of the frequency, which keeps the time step below the radius of
  /// convergence of the Taylor series. The frequency bound is the damping c plus the square root of
  /// the largest slope k + 3 mu y^2 of the restoring force, where mu y^4 / 4 <= E with the energy E
  /// = y'^2/2 + U(y).
  FPKCHECK_INLINE static Real frequency_bound(const SimulatedOscillator& o,
                                              const PhaseState<Real>& start) {
    const double k = o.force[1], mu = o.force[3];
    const Real y2 = start.y * start.y;
    const Real energy = 0.5 * (start.v * start.v) + y2 * (k / 2 + (mu / 4) * y2);
    return simd::square_root(k + 6.0 * simd::square_root(mu * energy)) + o.damping[0];
  }

  /// Computes the Taylor coefficients a_2, a_3, .. of y(s) from a_0 and a_1 by the recursion
  ///
  ///     (n+1)(n+2) a_{n+2} = -(c (n+1) a_{n+1} + k a_n + mu [y^3]_n).
  FPKCHECK_INLINE void compute_taylor_coefficients() {
    const double c = oscillator_.damping[0], k = oscillator_.force[1], mu = oscillator_.force[3];
    std::array<Real, kOrder - 1> square;  // coefficients [y^2]_n
    // The sums of the recursion add the newest Taylor coefficients last, so that the chain of
    // dependent operations is short.
#pragma GCC unroll 16
    for (int n = 0; n + 2 <= kOrder; ++n) {
      Real pairs{};
#pragma GCC unroll 16
      for (int i = (n + 1) / 2 - 1; i >= 0; --i) pairs = pairs + a_[i] * a_[n - i];
      square[n] = n % 2 == 0 ? 2.0 * pairs + a_[n / 2] * a_[n / 2] : 2.0 * pairs;
      Real cube{};
#pragma GCC unroll 16
      for (int i = 1; i < n; ++i) cube = cube + square[i] * a_[n - i];
      if (n > 0) cube = cube + square[0] * a_[n];
      cube = cube + square[n] * a_[0];
      a_[n + 2] =
          (k * a_[n] + mu * cube + (c * (n + 1)) * a_[n + 1]) * (-1.0 / ((n + 1) * (n + 2)));
    }
  }

  /// Returns a first approximation of the impact time: the value s(0) of the cubic s(y) with the
  /// slopes 1/v at the two ends of the flight. If the cubic gives a time outside the flight, the
  /// zero of the chord of y(s) is returned.
  FPKCHECK_INLINE Real impact_time_guess(const Real& end, const PhaseState<Real>& at_end) const {
    const Real drop = a_[0] - at_end.y;  // positive drop of y during the flight
    const Real u = a_[0] / drop;
    const Real u1 = 1.0 - u;
    const Real s = end * u * u * (3.0 - 2.0 * u) + u * u1 * drop * (u / at_end.v - u1 / a_[1]);
    using Mask = decltype(s > 0.0);
    const Mask inside = (s > 0.0) & (s < end);
    return simd::select(inside, s, end * u);
  }

  Real frequency_bound_;
};

}  // namespace fpkcheck::mcs
