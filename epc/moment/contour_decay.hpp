#pragma once

#include <optional>

#include "epc/form/polynomial.hpp"
#include "epc/half_plane/contour.hpp"
#include "epc/moment/energy_domain.hpp"

namespace fpkcheck::epc::moment {

/// Energy contour along the edge of a domain.
half_plane::Contour edge_contour(const EnergyDomain& domain);

/// Largest Q_n on the contour of an energy, which is defined as in EnergyDomain.
double largest_exponent_on_contour(const Polynomial& q, const problem::Problem& problem,
                                   double energy);

/// Decay with growing energy of the largest Q_n on an energy contour.
struct DecayScan {
  double peak;  ///< largest Q_n up to the first energy of the scan
  /// first energy at which the largest Q_n on the contour lies `depth` below the peak
  std::optional<double> crossing;
};

/// Scans contours of growing energy until the largest Q_n on a contour lies `depth` below the peak.
/// The energy `crossing` is empty if Q_n rises before this depth, or does not reach this depth up
/// to the energy `last_energy`.
DecayScan scan_decay(const Polynomial& q, const problem::Problem& problem, double first_energy,
                     double last_energy, double depth);

/// Depth below the peak of Q_n at which exp(Q_n) is negligible: e^-42 = 6e-19 of the peak. If Q_n
/// falls to this depth without a rise, the confinement level is the energy at this depth.
inline constexpr double kNegligibleDepth = 42;
/// Smallest ratio of a larger confinement level to the present level that justifies another
/// solution.
inline constexpr double kMinLevelRatio = 1.05;

}  // namespace fpkcheck::epc::moment
