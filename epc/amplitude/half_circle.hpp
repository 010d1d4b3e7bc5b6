#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>

/// Common part of the formulations whose exponent is a polynomial of the amplitude
/// rho = sqrt(v^2 + 2 V(y)) and one further coordinate, with one wall on the left.
namespace fpkcheck::epc::amplitude {

/// Energy rho^2/2 of an amplitude rho, and the inverse.
inline double energy_at(double rho) { return rho * rho / 2; }
inline double amplitude_at(double energy) { return std::sqrt(2 * energy); }

/// Exponent by amplitude and phase: theta from -pi/2 to pi/2, v = rho sin(theta).
using Exponent = std::function<double(double rho, double theta)>;

/// Equidistant phases on the half-circle, including its ends on the wall.
inline constexpr int kPhaseCount = 33;
const std::array<double, kPhaseCount>& phases();
/// Weight of a phase in the trapezoidal rule.
double phase_weight(int phase);

/// Maximum of an exponent over the phases at an amplitude.
double maximum_over_phase(const Exponent& exponent, double rho);

/// Decay of the maximum over the phases with growing amplitude.
struct DecayScan {
  std::optional<double> crossing;  ///< first amplitude at which it lies `depth` below its peak
  double extent;                   ///< amplitude at which it begins to rise, or `farthest`
};

/// Scans amplitudes from 0 until the maximum over the phases lies `depth` below its peak, or rises
/// again.
DecayScan scan_decay(const Exponent& exponent, double depth, double farthest);

}  // namespace fpkcheck::epc::amplitude
