#pragma once

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "problem/system.hpp"

namespace fpkcheck::exact {

/// The function amplitude exp(-damping t / 2) sin(frequency t + phase), t >= 0.
struct DecayingWave {
  double amplitude;  ///< >= 0
  double phase;      ///< 0 <= phase < pi
  double damping;    ///< c
  double frequency;  ///< w = sqrt(k - c^2/4)

  double envelope(double t) const { return amplitude * std::exp(-damping * t / 2); }
  double operator()(double t) const { return envelope(t) * std::sin(frequency * t + phase); }
  /// The time between two zeros.
  double half_period() const;
  /// The first zero after t = 0.
  double first_zero() const;
  /// The largest value of |wave|.
  double peak() const;
};

/// The response of u1 z + u2 z' to a unit impulse, up to its sign: +-(u1 h(t) + u2 h'(t)) with the
/// impulse response h(t) = exp(-ct/2) sin(wt)/w of the linear oscillator without a wall. The sign
/// is chosen such that the phase is below pi.
/// @pre c^2 < 4k
DecayingWave impulse_response(const problem::System& system, double u1, double u2);

/// The integral of f(wave(t)) over 0 <= t <= end, for a smooth f that varies over lengths of
/// 1/scale and vanishes at 0 at least quadratically. The integral is truncated where the product of
/// scale and envelope falls below 1e-9.
template <class Function>
double integrate_along_wave(const DecayingWave& wave, const Function& f, double scale, double end) {
  // On a panel neither the phase nor scale * wave changes by more than 2. The nearest poles of the
  // characteristic function 1 / (1 + (u scale)^2 / 2) of the Laplace law then allow 1e-16.
  constexpr double kMaxChange = 2;
  const double speed = std::hypot(wave.frequency, wave.damping / 2);  // |wave'| <= envelope * speed
  const auto integrand = [&](double t) { return f(wave(t)); };
  double integral = 0;
  for (double t = 0; t < end;) {
    const double size = scale * wave.envelope(t);
    if (size < 1e-9) break;
    const double stop = std::min(t + kMaxChange / speed / std::max(1.0, size), end);
    integral += boost::math::quadrature::gauss<double, 20>::integrate(integrand, t, stop);
    t = stop;
  }
  return integral;
}

}  // namespace fpkcheck::exact
