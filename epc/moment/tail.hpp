#pragma once

#include <optional>

#include "epc/form/polynomial.hpp"
#include "epc/half_plane/contour.hpp"
#include "epc/moment/energy_domain.hpp"

namespace fpkcheck::epc::moment {

/// The edge of a domain, as points.
half_plane::Contour contour(const EnergyDomain& domain);

/// The largest Q_n on the contour of an energy (EnergyDomain).
double largest_on_contour(const Polynomial& q, const problem::Problem& problem, double energy);

/// What Q_n does from one energy outwards, contour by contour.
struct Fall {
  double peak;                    ///< largest Q_n up to the first energy
  std::optional<double> reached;  ///< the energy at which Q_n has fallen by the depth asked for
};

/// Follows the largest Q_n on contours of growing energy until it lies `depth` below its peak
/// everywhere on one. Nothing is reached when it rises before, or at `farthest`.
Fall fall_of(const Polynomial& q, const problem::Problem& problem, double from, double farthest,
             double depth);

/// Where Q_n falls by this much without ever rising, the level lies there: what is beyond has less
/// than e^-42 = 6e-19 of the density's peak.
inline constexpr double kWholeDepth = 42;
/// How much farther out a level must lie to be worth another solution.
inline constexpr double kFurther = 1.05;

}  // namespace fpkcheck::epc::moment
