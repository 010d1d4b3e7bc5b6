#pragma once

#include <optional>

#include "epc/form/polynomial.hpp"
#include "epc/half_plane/contour.hpp"
#include "epc/moment/energy_domain.hpp"

namespace fpkcheck::epc::moment {

/// Quadrature points on the edge of a domain.
half_plane::Contour contour(const EnergyDomain& domain);

/// Largest Q_n on the contour of an energy (EnergyDomain).
double largest_on_contour(const Polynomial& q, const problem::Problem& problem, double energy);

/// Decay of the largest Q_n on a contour with growing energy.
struct DecayScan {
  double peak;                     ///< largest Q_n up to the first energy
  std::optional<double> crossing;  ///< first energy at which Q_n lies the depth below its peak
};

/// Scans contours of growing energy until the largest Q_n on one lies `depth` below the peak. The
/// energy is empty if Q_n rises before, or does not fall that far up to `farthest`.
DecayScan scan_decay(const Polynomial& q, const problem::Problem& problem, double from,
                     double farthest, double depth);

/// Depth at which exp(Q_n) is negligible: e^-42 = 6e-19 of the peak. If Q_n falls this far without
/// rising, the confinement level is there.
inline constexpr double kNegligibleDepth = 42;
/// Smallest ratio of a larger confinement level to the present one that justifies another solution.
inline constexpr double kMinLevelRatio = 1.05;

}  // namespace fpkcheck::epc::moment
