#pragma once

#include <array>

#include "mcs/motion/oscillator.hpp"
#include "mcs/motion/taylor_polynomial.hpp"
#include "numerics/simd/elementary.hpp"
#include "numerics/simd/simd.hpp"

namespace fpkcheck::mcs {

// Taylor coefficients of the free motion, paper (1) without impulses: y'' = -(c y' + g(y)), y >= 0.
// Each function has closed formulas for g(y) = k y + mu y^3. For other springs the functions loop
// over the powers of y instead of having a formula for each degree, which keeps the compile time
// short.

inline constexpr int kSeriesOrder = 12;

/// Coefficients a_n of y(s) = sum_n a_n s^n.
template <class Real>
using TaylorCoefficients = std::array<Real, kSeriesOrder + 1>;

/// Polynomial sum_n p_n y^n by Horner's rule, n up to `degree`.
template <class Real>
FPKCHECK_INLINE Real horner(const numerics::Polynomial& p, int degree, const Real& y) {
  Real sum{};
  for (int n = degree; n >= 0; --n) sum = sum * y + p.coefficient(static_cast<std::size_t>(n));
  return sum;
}

/// Spring force g(y).
template <class Real>
FPKCHECK_INLINE Real restoring_force(const Oscillator& oscillator, const Real& y) {
  if (oscillator.is_duffing) return y * (oscillator.stiffness + oscillator.cubic * (y * y));
  return horner(oscillator.force, oscillator.degree, y);
}

template <class Real>
FPKCHECK_INLINE void compute_duffing_coefficients(const Oscillator& oscillator,
                                                  TaylorCoefficients<Real>& a) {
  const double c = oscillator.damping, k = oscillator.stiffness, mu = oscillator.cubic;
  std::array<Real, kSeriesOrder - 1> square;  // [y^2]_n
  // Each sum adds the newest coefficients last, so that the chain of dependent operations is short.
#pragma GCC unroll 16
  for (int n = 0; n + 2 <= kSeriesOrder; ++n) {
    Real pairs{};
#pragma GCC unroll 16
    for (int i = (n + 1) / 2 - 1; i >= 0; --i) pairs = pairs + a[i] * a[n - i];
    square[n] = n % 2 == 0 ? 2.0 * pairs + a[n / 2] * a[n / 2] : 2.0 * pairs;
    Real cube{};
#pragma GCC unroll 16
    for (int i = 1; i < n; ++i) cube = cube + square[i] * a[n - i];
    if (n > 0) cube = cube + square[0] * a[n];
    cube = cube + square[n] * a[0];
    a[n + 2] = (k * a[n] + mu * cube + (c * (n + 1)) * a[n + 1]) * (-1.0 / ((n + 1) * (n + 2)));
  }
}

template <class Real>
FPKCHECK_INLINE void compute_polynomial_force_coefficients(const Oscillator& oscillator,
                                                           TaylorCoefficients<Real>& a) {
  const auto g = [&](int d) { return oscillator.force.coefficient(static_cast<std::size_t>(d)); };
  Real powers[Oscillator::kHighestDegree + 1][kSeriesOrder + 1];  // [y^d]_n
  powers[1][0] = a[0];
  powers[1][1] = a[1];
  for (int n = 0; n + 2 <= kSeriesOrder; ++n) {
    Real force = g(1) * powers[1][n];
    for (int d = 2; d <= oscillator.degree; ++d) {
      Real sum{};
      for (int i = 0; i <= n; ++i) sum = sum + powers[d - 1][i] * powers[1][n - i];
      powers[d][n] = sum;
      force = force + g(d) * sum;
    }
    powers[1][n + 2] =
        (force + (oscillator.damping * (n + 1)) * powers[1][n + 1]) * (-1.0 / ((n + 1) * (n + 2)));
  }
#pragma GCC unroll 16
  for (int n = 2; n <= kSeriesOrder; ++n) a[n] = powers[1][n];
}

/// Computes a_2, a_3, .. from a_0 and a_1,
///
///     (n+1)(n+2) a_{n+2} = -(c (n+1) a_{n+1} + sum_d g_d [y^d]_n).
///
/// Cauchy products give the coefficients [y^d]_n of the powers in the spring force.
template <class Real>
FPKCHECK_INLINE void compute_taylor_coefficients(const Oscillator& oscillator,
                                                 TaylorCoefficients<Real>& a) {
  if (oscillator.is_duffing) {
    compute_duffing_coefficients(oscillator, a);
  } else {
    compute_polynomial_force_coefficients(oscillator, a);
  }
}

/// Upper bound of the frequency: square root of the largest slope of the spring at the energy E =
/// y'^2/2 + U(y), plus c. The bound holds for the whole flight, since the energy does not grow. The
/// time step stays below the pole that limits the convergence of the Taylor series of a hardening
/// spring.
template <class Real>
FPKCHECK_INLINE Real frequency_bound(const Oscillator& o, const Real& y, const Real& v) {
  if (o.is_duffing) {
    // k + 3 mu y^2 with mu y^4 / 4 <= E
    const double k = o.stiffness, mu = o.cubic;
    const Real y2 = y * y;
    const Real energy = 0.5 * (v * v) + y2 * (k / 2 + (mu / 4) * y2);
    return simd::square_root(k + 6.0 * simd::square_root(mu * energy)) + o.damping;
  }
  constexpr double kSmallest = 1e-290;  // smallest argument of the logarithm
  const Real energy = 0.5 * (v * v) + horner(o.potential, o.degree + 1, y);
  const Real power =
      simd::lanewise_max(energy / o.potential_bound, simd::broadcast<Real>(kSmallest));
  const Real largest_y = simd::exponential(simd::logarithm(power) / (o.degree + 1.0));
  return simd::square_root(horner(o.slope_bound, o.degree - 1, largest_y)) + o.damping;
}

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
