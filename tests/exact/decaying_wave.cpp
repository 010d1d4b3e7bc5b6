#include "exact/decaying_wave.hpp"

#include <numbers>

namespace fpkcheck::exact {

using std::numbers::pi;

double DecayingWave::half_period() const { return pi / frequency; }

double DecayingWave::first_zero() const { return (pi - phase) / frequency; }

double DecayingWave::peak() const {
  // The derivative is zero where tan(w t + phase) = 2 w / c.
  double angle = std::atan2(2 * frequency, damping) - phase;
  if (angle < 0) angle += pi;
  return std::max(std::abs((*this)(0)), std::abs((*this)(angle / frequency)));
}

DecayingWave impulse_response(const problem::System& system, double u1, double u2) {
  const double c = system.damping();
  const double w = std::sqrt(system.stiffness() - c * c / 4);
  // h' = exp(-ct/2) (cos wt - c/(2w) sin wt)
  const double sine = (u1 - c * u2 / 2) / w;
  double phase = std::atan2(u2, sine);
  if (phase < 0) phase += pi;
  if (phase >= pi) phase = 0;
  return {std::hypot(sine, u2), phase, c, w};
}

}  // namespace fpkcheck::exact
