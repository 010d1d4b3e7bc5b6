#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "numerics/quadrature/gauss_rule.hpp"

/// Common functions of the closures in amplitude and phase (epc/polar) and in amplitude and
/// velocity (epc/contact). The exponent of the closure is a polynomial of the amplitude rho =
/// sqrt(v^2 + 2 V(y)), with the potential V, and of a second coordinate (phase or velocity). The
/// oscillator of a closure in the amplitude has exactly one wall, on the left.
namespace fpkcheck::epc::amplitude {

inline double energy_of_amplitude(double rho) { return rho * rho / 2; }
inline double amplitude_of_energy(double energy) { return std::sqrt(2 * energy); }

/// Exponent of the density as a function of the amplitude rho and the phase theta, -pi/2 <= theta
/// <= pi/2, where v = rho sin(theta).
using ExponentInPolarCoordinates = std::function<double(double rho, double theta)>;

inline constexpr int kPhaseCount = 33;
/// Returns equidistant phases from -pi/2 to pi/2, including both end points.
const std::array<double, kPhaseCount>& equidistant_phases();
/// Returns the weight of one phase in the trapezoidal rule over the phase from -pi/2 to pi/2.
double trapezoidal_phase_weight(int phase_index);

double maximum_over_phase(const ExponentInPolarCoordinates& exponent, double rho);

struct ExponentDecayRange {
  /// First amplitude at which the maximum over phases of the exponent lies `depth` below its peak
  std::optional<double> crossing;
  /// Amplitude at which the exponent of the density, maximised over the phase, begins to rise
  /// again, or `last_amplitude`
  double extent;
};

/// Scans increasing amplitudes until the maximum over all phases of the exponent of the density
/// lies `depth` below its peak or rises again.
ExponentDecayRange find_exponent_decay_range(const ExponentInPolarCoordinates& exponent,
                                             double depth, double last_amplitude);

/// Returns a composite Gauss-Legendre rule on [0, end] with one panel between successive break
/// points. The number of quadrature points of a panel is a constant plus a multiple of the panel
/// width.
numerics::QuadratureRule piecewise_gauss_legendre_rule(double end,
                                                       const std::vector<double>& breaks,
                                                       int point_count);

}  // namespace fpkcheck::epc::amplitude
