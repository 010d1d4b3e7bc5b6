#pragma once

#include <optional>
#include <vector>

#include "fd_fpk/characteristics/flow.hpp"
#include "fd_fpk/operator/grid.hpp"

namespace fpkcheck::fd_fpk {

/// A cell and its fraction of the mass at rest.
struct CellFraction {
  int cell;
  double share;
};

/// A rest point of the motion. Either a stable equilibrium, about which the motion decays for ever,
/// or contact with a wall to which the force presses the mass. Contact occurs after infinitely many
/// impacts in a finite time, and the law has an atom there.
struct RestPoint {
  double y;
  std::optional<Side> contact = {};  ///< the wall in contact, if any
  /// The innermost cells. The residual motion about an equilibrium is distributed over them in
  /// proportion to the time spent there; motion that starts in them in contact comes to rest.
  std::vector<CellFraction> cells = {};
  /// Motion with less energy does not leave these cells; unused in contact.
  double escape_energy = 0;
  /// Impacts per unit time of mass at rest in an equilibrium at a wall.
  double impact_rate = 0;
};

/// All rest points, by increasing y, with their cells.
/// @param rate arrival rate of the impulses
std::vector<RestPoint> rest_points(const Flow& flow, const Grid& grid, double rate);

/// All rest points, without cells.
std::vector<RestPoint> rest_points(const Flow& flow);

/// Distance to an equilibrium, relative to the typical amplitude A, below which cells have a
/// constant width. The innermost cells contain the mass at rest. With one impulse in several decay
/// times this is most of the mass, while the standard deviation s and the mean are small against A:
/// s / A goes as the square root of the impulses per decay time, the mean as (s / A)^2. The cells
/// are a thousandth of the mean, and narrower than the narrowest bins next to 0, 8e-4 s
/// (compare/axes.cpp).
double relative_core_width(double deviation, double typical_amplitude);

/// The cascade of impacts that follows a motion off a wall towards which the acceleration a is
/// nearly constant: speeds r^n u, in a total time of 2 u / (a (1 - r)).
struct Cascade {
  double rest_probability;  ///< probability of rest before the next impulse
  double momentum;          ///< sum of the impact speeds, over all impacts
  double energy;            ///< sum of their squares
};
/// @param force_towards_wall the acceleration towards the wall, > 0
Cascade cascade(double speed, double force_towards_wall, double restitution, double rate);

}  // namespace fpkcheck::fd_fpk
