#pragma once

#include <array>

#include "mcs/motion/general_oscillator.hpp"
#include "mcs/motion/taylor_polynomial.hpp"
#include "numerics/simd/elementary.hpp"
#include "numerics/simd/simd.hpp"

// Included by files that are compiled for different instruction sets, as motion/advance_simd.hpp.
namespace fpkcheck::mcs {
namespace {

/// Coefficients a_n of y(s) = sum_n a_n s^n.
template <class Real, int kOrder>
using GeneralTaylorCoefficients = std::array<Real, kOrder + 1>;

template <class Real>
FPKCHECK_INLINE Real general_stiffness(const GeneralOscillator& o, const Real& y) {
  Real sum = simd::broadcast<Real>(5 * o.force[5]);
  for (std::size_t n = 4; n > 0; --n) sum = sum * y + static_cast<double>(n) * o.force[n];
  return sum;
}

/// Coefficient n of the product of two series, [a b]_n.
template <class A, class B>
FPKCHECK_INLINE auto cauchy_product(const A& a, const B& b, int n) {
  auto sum = a[0] * b[n];
#pragma GCC unroll 16
  for (int i = 1; i <= n; ++i) sum = sum + a[i] * b[n - i];
  return sum;
}

/// Computes a_2, a_3, .. from a_0 and a_1,
///
///     (n+1)(n+2) a_{n+2} = -([g(y)]_n + (n+1) [C(y)]_{n+1} + c_vv [v^3]_n),    C' = c.
///
/// Cauchy products give the coefficients of powers; c(y) v = dC(y)/ds.
template <GeneralOscillator::Kind kKind, int kOrder, class Real>
FPKCHECK_INLINE void compute_general_coefficients_inline(
    const GeneralOscillator& o, GeneralTaylorCoefficients<Real, kOrder>& a) {
  using Kind = GeneralOscillator::Kind;
  const double c0 = o.damping[0], c1 = o.damping[1] / 2, c2 = o.damping[2] / 3;
  std::array<Real, kOrder + 1> y2, y3, y4, y5, v, v2;
  if constexpr (kKind != Kind::linear) {
    y2[0] = a[0] * a[0];
    y3[0] = y2[0] * a[0];
  }
#pragma GCC unroll 16
  for (int n = 0; n + 2 <= kOrder; ++n) {
    Real sum = o.force[1] * a[n] + (c0 * (n + 1)) * a[n + 1];
    if (n == 0) sum = sum + o.force[0];
    if constexpr (kKind != Kind::linear) {
      y2[n + 1] = cauchy_product(a, a, n + 1);
      y3[n + 1] = cauchy_product(a, y2, n + 1);
      sum = sum + o.force[2] * y2[n] + o.force[3] * y3[n] +
            static_cast<double>(n + 1) * (c1 * y2[n + 1] + c2 * y3[n + 1]);
    }
    if constexpr (kKind == Kind::full) {
      y4[n] = cauchy_product(y2, y2, n);
      y5[n] = cauchy_product(y2, y3, n);
      v[n] = static_cast<double>(n + 1) * a[n + 1];
      v2[n] = cauchy_product(v, v, n);
      sum = sum + o.force[4] * y4[n] + o.force[5] * y5[n] + o.rayleigh * cauchy_product(v2, v, n);
    }
    a[n + 2] = sum * (-1.0 / ((n + 1) * (n + 2)));
  }
}

// The function is not inlined, since the compiler would otherwise generate a copy for each call.
template <GeneralOscillator::Kind kKind, int kOrder, class Real>
__attribute__((noinline)) void compute_general_coefficients_of_kind(
    const GeneralOscillator& o, GeneralTaylorCoefficients<Real, kOrder>& a) {
  compute_general_coefficients_inline<kKind, kOrder>(o, a);
}

template <int kOrder, class Real>
FPKCHECK_INLINE void compute_general_coefficients(const GeneralOscillator& o,
                                                  GeneralTaylorCoefficients<Real, kOrder>& a) {
  using Kind = GeneralOscillator::Kind;
  switch (o.kind) {
    case Kind::linear:
      return compute_general_coefficients_of_kind<Kind::linear, kOrder, Real>(o, a);
    case Kind::cubic:
      return compute_general_coefficients_of_kind<Kind::cubic, kOrder, Real>(o, a);
    case Kind::full:
      return compute_general_coefficients_of_kind<Kind::full, kOrder, Real>(o, a);
  }
}

/// The motion of a GeneralOscillator between two events, as a Taylor polynomial in time.
template <class Real, int kOrder>
class GeneralFlight {
 public:
  /// @param oscillator must outlive the flight
  FPKCHECK_INLINE GeneralFlight(const GeneralOscillator& oscillator, const BasicState<Real>& start)
      : oscillator_(oscillator) {
    a_[0] = start.y;
    a_[1] = start.v;
    compute_general_coefficients<kOrder, Real>(oscillator, a_);
  }

  /// Keeps the mass at its initial position in the given lanes.
  template <class Mask>
  FPKCHECK_INLINE void hold_position(const Mask& in_contact) {
#pragma GCC unroll 16
    for (int n = 1; n <= kOrder; ++n) a_[n] = simd::select(in_contact, Real{}, a_[n]);
  }

  /// Longest time for which the polynomial is used: `phase` radians of a frequency w. This
  /// frequency satisfies |d^n y/ds^n| <= A w^n for the last coefficients, with the extent A of the
  /// motion, and w^2 is at least the tangent stiffness. The initial energy gives no bound of w,
  /// since the energy may grow.
  ///
  /// The velocity of a flight obeys a linear equation with the coefficient g'(y). Within less than
  /// half a period (phase < pi) the velocity changes its sign at most once (Sturm).
  FPKCHECK_INLINE Real max_step(double phase) const {
    const Real extent = oscillator_.length + simd::lanewise_max(a_[0], -a_[0]);
    const Real over = 1.0 / extent;
    Real logarithm_of_frequency = simd::broadcast<Real>(-1e3);
    double factorial = 1;
#pragma GCC unroll 16
    for (int n = 2; n <= kOrder; ++n) {
      factorial *= n;
      if (n <= kOrder - kTestedOrders) continue;
      const Real size = factorial * simd::lanewise_max(a_[n], -a_[n]) * over + 1e-290;
      logarithm_of_frequency =
          simd::lanewise_max(logarithm_of_frequency, simd::logarithm(size) * (1.0 / n));
    }
    const double longest = 1e-2 * oscillator_.frequency;
    Real frequency = simd::exponential(simd::lanewise_max(logarithm_of_frequency,
                                                          simd::broadcast<Real>(-600.0))) +
                     longest;
    const Real slope = general_stiffness(oscillator_, a_[0]);
    const Real stiffness = simd::lanewise_max(slope, -slope);
    const Real c = oscillator_.damping[0] +
                   a_[0] * (oscillator_.damping[1] + a_[0] * oscillator_.damping[2]) +
                   (3 * oscillator_.rayleigh) * (a_[1] * a_[1]);
    frequency =
        simd::lanewise_max(frequency, simd::square_root(stiffness) + simd::lanewise_max(c, -c));
    return phase / frequency;
  }

  FPKCHECK_INLINE BasicState<Real> state_at_time(const Real& s) const {
    return state_at<kOrder>(a_, s);
  }

  FPKCHECK_INLINE Real acceleration(const Real& s) const { return acceleration_at<kOrder>(a_, s); }

  /// Zero of v in [0, end], in the lanes where v(0) and v(end) have different signs. The error is
  /// 1e-6 of the time to either end, which causes an error of 1e-12 in y.
  template <class Mask>
  FPKCHECK_INLINE Real turning_time(const Real& end, const BasicState<Real>& at_end,
                                    const Mask& wanted) const {
    Real low{}, high = end;
    Real s = end * (a_[1] / (a_[1] - simd::select(wanted, at_end.v, -a_[1] - 1.0)));
    Mask open = wanted;
    for (int n = 0; n < kMostIterations && simd::any_lane_set(open); ++n) {
      const Real v = state_at_time(s).v;
      const Mask before = v * a_[1] > 0.0;
      low = simd::select(before, s, low);
      high = simd::select(before, high, s);
      const Real newton = s - v / acceleration(s);
      const Mask inside = (newton >= low) & (newton <= high);
      const Real next = simd::select(inside, newton, 0.5 * (low + high));
      const Real moved = simd::lanewise_max(next - s, s - next);
      s = simd::select(open, next, s);
      open = open & (moved > 1e-4 * s);
    }
    return s;
  }

  /// Zero of y(s) - wall in [low, high], to rounding, in the lanes of `wanted`, where
  /// `inside` * (y - wall) changes from positive to negative.
  /// @param guess within [low, high]
  template <class Mask>
  FPKCHECK_INLINE Real impact_time(const Real& wall, const Real& inside, Real low, Real high,
                                   const Real& guess, const Mask& wanted) const {
    Real s = guess;
    Mask open = wanted;
    for (int n = 0; n < kMostIterations && simd::any_lane_set(open); ++n) {
      const BasicState<Real> state = state_at_time(s);
      const Real distance = inside * (state.y - wall), speed = inside * state.v;
      const Mask before = distance > 0.0;
      low = simd::select(before, s, low);
      high = simd::select(before, high, s);
      const Real halley =
          s - distance * speed / (speed * speed - 0.5 * (distance * (inside * acceleration(s))));
      const Mask fine = (halley >= low) & (halley <= high);
      const Real next = simd::select(fine, halley, 0.5 * (low + high));
      const Real moved = simd::lanewise_max(next - s, s - next);
      s = simd::select(open, next, s);
      // After a third-order correction of 1e-6 the error is rounding.
      open = open & (moved > 1e-6 * s);
    }
    return s;
  }

 private:
  static constexpr int kMostIterations = 60;
  // For y'' = -y^5 and y(0) = 0 only every sixth coefficient differs from 0.
  static constexpr int kTestedOrders = 6;

  const GeneralOscillator& oscillator_;
  GeneralTaylorCoefficients<Real, kOrder> a_;
};

}  // namespace
}  // namespace fpkcheck::mcs
