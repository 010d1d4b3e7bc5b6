#pragma once

#include <array>

#include "mcs/motion/free_flight.hpp"
#include "numerics/simd/elementary_functions.hpp"

// polynomial_flight.hpp is compiled for several instruction sets.
namespace fpkcheck::mcs {
namespace {

template <class Real>
FPKCHECK_INLINE Real tangent_stiffness(const SimulatedOscillator& o, const Real& y) {
  Real sum = simd::all_lanes_equal_to<Real>(5 * o.force[5]);
  for (std::size_t n = 4; n > 0; --n) sum = sum * y + static_cast<double>(n) * o.force[n];
  return sum;
}

/// Returns the coefficient [a b]_n of the product of two power series a and b.
template <class A, class B>
FPKCHECK_INLINE auto cauchy_product(const A& a, const B& b, int n) {
  auto sum = a[0] * b[n];
#pragma GCC unroll 16
  for (int i = 1; i <= n; ++i) sum = sum + a[i] * b[n - i];
  return sum;
}

/// Computes the Taylor coefficients a_2, a_3, .. of y(s) from a_0 and a_1 by the recursion
///
///     (n+1)(n+2) a_{n+2} = -([g(y)]_n + (n+1) [C(y)]_{n+1} + c_vv [v^3]_n),    C' = c.
///
/// Cauchy products give the Taylor coefficients of powers of y and v. The Taylor coefficients of
/// the damping force c(y) v follow from c(y) v = dC(y)/ds, where C(y) is the integral of the
/// damping coefficient c(y).
template <SimulatedOscillator::Kind kKind, int kOrder, class Real>
FPKCHECK_INLINE void compute_taylor_coefficients_inline(const SimulatedOscillator& o,
                                                        std::array<Real, kOrder + 1>& a) {
  const double c0 = o.damping[0], c1 = o.damping[1] / 2, c2 = o.damping[2] / 3;
  std::array<Real, kOrder + 1> y2, y3, y4, y5, v, v2;
  if constexpr (kKind != SimulatedOscillator::Kind::linear) {
    y2[0] = a[0] * a[0];
    y3[0] = y2[0] * a[0];
  }
#pragma GCC unroll 16
  for (int n = 0; n + 2 <= kOrder; ++n) {
    Real sum = o.force[1] * a[n] + (c0 * (n + 1)) * a[n + 1];
    if (n == 0) sum = sum + o.force[0];
    if constexpr (kKind != SimulatedOscillator::Kind::linear) {
      y2[n + 1] = cauchy_product(a, a, n + 1);
      y3[n + 1] = cauchy_product(a, y2, n + 1);
      sum = sum + o.force[2] * y2[n] + o.force[3] * y3[n] +
            static_cast<double>(n + 1) * (c1 * y2[n + 1] + c2 * y3[n + 1]);
    }
    if constexpr (kKind == SimulatedOscillator::Kind::full) {
      y4[n] = cauchy_product(y2, y2, n);
      y5[n] = cauchy_product(y2, y3, n);
      v[n] = static_cast<double>(n + 1) * a[n + 1];
      v2[n] = cauchy_product(v, v, n);
      sum = sum + o.force[4] * y4[n] + o.force[5] * y5[n] + o.rayleigh * cauchy_product(v2, v, n);
    }
    a[n + 2] = sum * (-1.0 / ((n + 1) * (n + 2)));
  }
}

// The computation of the Taylor coefficients is not inlined, since the compiler would otherwise
// generate a copy for each call.
template <SimulatedOscillator::Kind kKind, int kOrder, class Real>
[[gnu::noinline]] void compute_taylor_coefficients_of_kind(const SimulatedOscillator& o,
                                                           std::array<Real, kOrder + 1>& a) {
  compute_taylor_coefficients_inline<kKind, kOrder>(o, a);
}

template <int kOrder, class Real>
FPKCHECK_INLINE void compute_taylor_coefficients(const SimulatedOscillator& o,
                                                 std::array<Real, kOrder + 1>& a) {
  switch (o.kind) {
    case SimulatedOscillator::Kind::linear:
      return compute_taylor_coefficients_of_kind<SimulatedOscillator::Kind::linear, kOrder, Real>(
          o, a);
    case SimulatedOscillator::Kind::duffing_at_wall:
    case SimulatedOscillator::Kind::cubic:
      return compute_taylor_coefficients_of_kind<SimulatedOscillator::Kind::cubic, kOrder, Real>(o,
                                                                                                 a);
    case SimulatedOscillator::Kind::full:
      return compute_taylor_coefficients_of_kind<SimulatedOscillator::Kind::full, kOrder, Real>(o,
                                                                                                a);
    case SimulatedOscillator::Kind::formula:  // flights are FormulaFlights
      return;
  }
}

/// Free flight of an oscillator of any kind except `formula`, as a Taylor polynomial.
template <class Real, int kOrder>
class PolynomialFlight : public FreeFlight<Real, kOrder> {
  using Base = FreeFlight<Real, kOrder>;
  using Base::a_;
  using Base::oscillator_;

 public:
  /// @param oscillator must outlive the flight
  FPKCHECK_INLINE PolynomialFlight(const SimulatedOscillator& oscillator,
                                   const PhaseState<Real>& start)
      : Base(oscillator, start) {
    compute_taylor_coefficients<kOrder, Real>(oscillator, a_);
  }

  /// Returns the longest duration of a PolynomialFlight, which is `phase` radians of a frequency w.
  /// The frequency w satisfies |d^n y/ds^n| <= A w^n for the last Taylor coefficients, with the
  /// extent A of the motion, and w^2 is at least the tangent stiffness. The initial energy of a
  /// PolynomialFlight gives no bound of the frequency, since the energy may grow.
  ///
  /// The velocity of a PolynomialFlight satisfies a linear equation with the coefficient g'(y). By
  /// Sturm's theorem, the velocity changes sign at most once within less than half a period (phase
  /// < pi).
  FPKCHECK_INLINE Real max_flight_duration(double phase) const {
    const Real extent = oscillator_.length + simd::lanewise_max(a_[0], -a_[0]);
    const Real over = 1.0 / extent;
    Real logarithm_of_frequency = simd::all_lanes_equal_to<Real>(-1e3);
    double factorial = 1;
#pragma GCC unroll 16
    for (int n = 2; n <= kOrder; ++n) {
      factorial *= n;
      if (n <= kOrder - kTaylorOrdersInStepEstimate) continue;
      const Real size = factorial * simd::lanewise_max(a_[n], -a_[n]) * over + 1e-290;
      logarithm_of_frequency =
          simd::lanewise_max(logarithm_of_frequency, simd::logarithm(size) * (1.0 / n));
    }
    const double longest = 1e-2 * oscillator_.frequency;
    Real frequency = simd::exponential(simd::lanewise_max(logarithm_of_frequency,
                                                          simd::all_lanes_equal_to<Real>(-600.0))) +
                     longest;
    const Real slope = tangent_stiffness(oscillator_, a_[0]);
    const Real stiffness = simd::lanewise_max(slope, -slope);
    const Real c = oscillator_.damping[0] +
                   a_[0] * (oscillator_.damping[1] + a_[0] * oscillator_.damping[2]) +
                   (3 * oscillator_.rayleigh) * (a_[1] * a_[1]);
    frequency =
        simd::lanewise_max(frequency, simd::square_root(stiffness) + simd::lanewise_max(c, -c));
    return phase / frequency;
  }

 private:
  // The frequency bound must use Taylor coefficients of six successive orders: for y'' = -y^5 and
  // y(0) = 0 only every sixth Taylor coefficient differs from 0.
  static constexpr int kTaylorOrdersInStepEstimate = 6;
};

}  // namespace
}  // namespace fpkcheck::mcs
