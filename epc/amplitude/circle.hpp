#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>

/// What the formulations share whose exponents are polynomials of the amplitude
/// rho = sqrt(v^2 + 2 V(y)) and of another coordinate, about one wall on the left.
namespace fpkcheck::epc::amplitude {

/// The energy at an amplitude, and the amplitude at an energy.
inline double energy_at(double rho) { return rho * rho / 2; }
inline double amplitude_at(double energy) { return std::sqrt(2 * energy); }

/// An exponent on the half-circle of an amplitude: theta from -pi/2 to pi/2, v = rho sin(theta).
using Exponent = std::function<double(double rho, double theta)>;

/// Phases, evenly over the half-circle, its ends on the wall among them.
inline constexpr int kPhases = 33;
const std::array<double, kPhases>& phases();
/// The trapezoidal rule on them.
double phase_weight(int phase);

/// The largest exponent at an amplitude.
double largest_at(const Exponent& exponent, double rho);

/// What an exponent does from the origin outwards, amplitude by amplitude.
struct Fall {
  std::optional<double> reached;  ///< least amplitude at which it lies `depth` below its peak
  double turning;                 ///< where it stopped to fall, or `farthest`
};

/// Follows the largest exponent of an amplitude until it lies `depth` below its peak, or rises
/// again.
Fall fall_of(const Exponent& exponent, double depth, double farthest);

}  // namespace fpkcheck::epc::amplitude
