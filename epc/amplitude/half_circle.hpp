#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "numerics/quadrature/gauss_rule.hpp"

/// Common part of the formulations polar and contact: the exponent is a polynomial of the amplitude
/// rho = sqrt(v^2 + 2 V(y)) and one further coordinate. The problem has one wall on the left.
namespace fpkcheck::epc::amplitude {

/// Energy rho^2/2 of an amplitude rho.
inline double energy_of_amplitude(double rho) { return rho * rho / 2; }
/// Amplitude rho of an energy rho^2/2.
inline double amplitude_of_energy(double energy) { return std::sqrt(2 * energy); }

/// Function that returns an exponent from amplitude rho and phase theta; theta lies between -pi/2
/// and pi/2, and v = rho sin(theta).
using PolarExponent = std::function<double(double rho, double theta)>;

/// Number of equidistant phases on the half-circle.
inline constexpr int kPhaseCount = 33;
/// Equidistant phases theta on the half-circle, including both ends of the half-circle on the wall.
const std::array<double, kPhaseCount>& scan_phases();
/// Weight in the trapezoidal rule of the phase with a given index.
double trapezoidal_phase_weight(int phase_index);

/// Maximum of an exponent over the phases of the half-circle at an amplitude.
double maximum_over_phase(const PolarExponent& exponent, double rho);

/// Decay with growing amplitude of an exponent's maximum over the phases.
struct DecayScan {
  /// first amplitude at which the exponent's maximum over the phases lies `depth` below its peak
  std::optional<double> crossing;
  /// amplitude at which the maximum over the phases begins to rise, or `last_amplitude`
  double extent;
};

/// Scans growing amplitudes, from 0 on. The scan ends when the maximum over the phases lies `depth`
/// below its peak, when this maximum rises again, or at the amplitude `last_amplitude`.
DecayScan scan_decay(const PolarExponent& exponent, double depth, double last_amplitude);

/// Gauss-Legendre rule on [0, end] with one panel between successive breaks. The number of points
/// of a panel is proportional to the width of the panel, plus a constant.
/// @param breaks increasing, between 0 and end
numerics::QuadratureRule legendre_panels(double end, const std::vector<double>& breaks,
                                         int point_count);

}  // namespace fpkcheck::epc::amplitude
