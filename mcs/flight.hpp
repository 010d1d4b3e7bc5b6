#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "problem/system.hpp"

namespace fpkcheck::mcs {

/// Position y >= 0 and velocity y' of the oscillator.
struct State {
  double y;
  double v;
};

/// The motion from one event to the next: the Taylor polynomial, about a given state, of the
/// solution of paper (1) without impulses,
///
///     y'' = -(c y' + k y + mu y^3),   y(s) = sum_n a_n s^n,
///     (n+1)(n+2) a_{n+2} = -(c (n+1) a_{n+1} + k a_n + mu [y^3]_n),
///
/// [y^3]_n by Cauchy products. It is trusted over a fraction of the shortest period that the energy
/// at the start allows; see reach().
class Flight {
 public:
  static constexpr int kOrder = 10;

  Flight(const problem::System& system, const State& start) {
    const double c = system.damping(), k = system.stiffness(), mu = system.cubic();
    a_[0] = start.y;
    a_[1] = start.v;
    std::array<double, kOrder - 1> square;  // [y^2]_n
    // The newest coefficients enter each sum last: the recursion waits for them only.
#pragma GCC unroll 16
    for (int n = 0; n + 2 <= kOrder; ++n) {
      double pairs = 0;
#pragma GCC unroll 16
      for (int i = (n + 1) / 2 - 1; i >= 0; --i) pairs += a_[i] * a_[n - i];
      square[n] = 2 * pairs + (n % 2 == 0 ? a_[n / 2] * a_[n / 2] : 0);
      double cube = 0;
#pragma GCC unroll 16
      for (int i = 1; i < n; ++i) cube += square[i] * a_[n - i];
      if (n > 0) cube += square[0] * a_[n];
      cube += square[n] * a_[0];
      a_[n + 2] = -(k * a_[n] + mu * cube + c * (n + 1) * a_[n + 1]) * (1.0 / ((n + 1) * (n + 2)));
    }
    // The tangent stiffness k + 3 mu y^2 at the largest excursion: mu y^4 / 4 <= E, and the energy
    // E does not grow. (The series of a cubic oscillator converges only up to a pole, which this
    // keeps away.)
    const double y2 = start.y * start.y;
    const double energy = start.v * start.v / 2 + y2 * (k / 2 + mu * y2 / 4);
    frequency_bound_ = std::sqrt(k + 6 * std::sqrt(mu * energy)) + c;
  }

  /// How long the polynomial is used: `phase` radians of the fastest motion possible from here.
  ///
  /// For phase < pi there is at most one impact within that time, and none if the flight starts at
  /// the wall with v >= 0: by Sturm's comparison theorem zeros of a solution of
  /// y'' + c y' + (k + mu y^2) y = 0 are at least pi / sqrt(k + mu max y^2) apart. So the sign of y
  /// at the end tells whether there was an impact, and impacts cannot accumulate.
  double reach(double phase) const { return phase / frequency_bound_; }

  /// The state s after the start. (Horner's rule in s^2 for even and odd powers apart: half as long
  /// a chain of operations that wait for one another.)
  State at(double s) const {
    static_assert(kOrder % 2 == 0);
    const double s2 = s * s;
    double y_even = a_[kOrder], v_odd = kOrder * a_[kOrder];
    double y_odd = 0, v_even = 0;
#pragma GCC unroll 16
    for (int n = kOrder - 1; n >= 1; n -= 2) {
      y_odd = y_odd * s2 + a_[n];
      v_even = v_even * s2 + n * a_[n];
      y_even = y_even * s2 + a_[n - 1];
      if (n > 1) v_odd = v_odd * s2 + (n - 1) * a_[n - 1];
    }
    return {y_even + s * y_odd, v_even + s * v_odd};
  }

  /// The zero of y(s) in [0, end], to rounding. Needs y(0) > 0 > y(end).
  double impact_time(double end) const {
    double above = 0, below = end;
    // The chord's zero to begin with; then Newton, kept inside the bracket.
    double s = end * a_[0] / (a_[0] - at(end).y);
    for (int iteration = 0; iteration < 60; ++iteration) {
      const State state = at(s);
      (state.y < 0 ? below : above) = s;
      const double newton = s - state.y / state.v;
      const double next = newton >= above && newton <= below ? newton : (above + below) / 2;
      // Quadratic convergence: a correction of 1e-8 leaves an error of the order of 1e-16.
      const bool done = std::abs(next - s) <= 1e-8 * end;
      s = next;
      if (done) break;
    }
    return s;
  }

 private:
  std::array<double, kOrder + 1> a_;
  double frequency_bound_;
};

}  // namespace fpkcheck::mcs
