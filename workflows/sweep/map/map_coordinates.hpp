#pragma once

#include <string>

#include "problem/problem.hpp"
#include "workflows/sweep/result/dimensionless_groups.hpp"

namespace fpkcheck::sweep {

/// The coordinates of a problem in the validity map: the dimensionless parameters that determine
/// the density up to the units of length and time.
struct MapCoordinates {
  DimensionlessGroups groups;
  double restitution;
  std::string law;
  double relative_mean;  ///< E[Y] / sqrt(E[Y^2]) of the impulses
};

MapCoordinates map_coordinates(const problem::Problem& problem);

/// The distance between two problems in the validity map:
///
///     sqrt( (ln N1/N2)^2 + (ln zeta1/zeta2)^2 + ((r1 - r2)/0.1)^2 + ((s1 - s2)/0.2)^2 ),
///
/// where N is the number of impulses per decay time, zeta the damping ratio, r the restitution
/// coefficient, and s the cubic fraction of the stiffness. A distance of 1 corresponds to a factor
/// e in N or zeta, to 0.1 in r, or to 0.2 in s. docs/validity.md shows the effect of such changes
/// on the errors. The distance is infinite if the impulse laws or the relative means differ.
double map_distance(const MapCoordinates& one, const MapCoordinates& other);

}  // namespace fpkcheck::sweep
