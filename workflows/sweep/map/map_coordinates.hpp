#pragma once

#include <string>

#include "problem/problem.hpp"
#include "workflows/sweep/result/dimensionless_groups.hpp"

namespace fpkcheck::sweep {

/// Coordinates in the validity map: the dimensionless parameters that determine the density up to
/// units.
struct MapCoordinates {
  DimensionlessGroups groups;
  double restitution;
  std::string law;
  double relative_mean;  ///< E[Y] / sqrt(E[Y^2]) of the impulses
};

MapCoordinates map_coordinates(const problem::Problem& problem);

/// Distance of two problems:
///
///     sqrt( (ln N1/N2)^2 + (ln zeta1/zeta2)^2 + ((r1 - r2)/0.1)^2 + ((s1 - s2)/0.2)^2 ),
///
/// N impulses per decay time, zeta the damping ratio, r the restitution coefficient, s the cubic
/// fraction of the stiffness. One unit is a factor e in N or zeta, 0.1 in r, or 0.2 in s.
/// docs/validity.md shows the effect of such changes on the errors. Infinite between different laws
/// or different relative means.
double distance(const MapCoordinates& one, const MapCoordinates& other);

}  // namespace fpkcheck::sweep
