#pragma once

#include <optional>
#include <vector>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/characteristics/flow.hpp"

namespace fpkcheck::fd_fpk {

/// A cell, and the fraction of the mass at rest that the cell contains.
struct RestMassShare {
  int cell;
  double share;
};

/// A rest point of the motion. A rest point is either a stable equilibrium, to which the motion
/// decays without reaching it in finite time, or contact with a wall against which the force
/// presses the oscillator. Contact begins after infinitely many impacts in a finite time, and the
/// stationary law has an atom at the point of contact.
struct RestPoint {
  double y;
  std::optional<WallSide> contact = {};  ///< the wall of the contact; empty for an equilibrium
  /// The innermost cells around the rest point. For an equilibrium, the residual motion about it is
  /// distributed over these cells in proportion to the time spent in each. For contact, motion that
  /// starts in these cells comes to rest.
  std::vector<RestMassShare> cells = {};
  /// Energy below which motion does not leave the cells of an equilibrium; unused for contact.
  double escape_energy = 0;
  /// Number of impacts per unit time of the residual motion at an equilibrium at a wall.
  double impact_rate = 0;
};

/// All rest points of the motion, by increasing y, with their innermost cells.
/// @param impulse_rate arrival rate of impulses, per unit time
std::vector<RestPoint> rest_points(const Flow& flow, const Grid& grid, double impulse_rate);

/// All rest points of the motion, by increasing y, without their innermost cells.
std::vector<RestPoint> rest_points(const Flow& flow);

/// Distance to an equilibrium, relative to the typical amplitude A, below which cells have a
/// constant width. The innermost cells contain the mass at rest. If only one impulse occurs in
/// several decay times, the mass at rest is most of the mass, and the standard deviation s and the
/// mean are small compared with A: s / A is proportional to the square root of the number of
/// impulses per decay time, mean / A to (s / A)^2. The width of these cells is a thousandth of the
/// mean, and less than that of the narrowest bins next to 0, 8e-4 s (compare/comparison_axes.cpp).
double relative_core_width(double deviation, double typical_amplitude);

/// The cascade of impacts with which a motion off a wall comes to rest in contact. The acceleration
/// a towards the wall is nearly constant. For an initial speed u the impact speeds are r^n u, n =
/// 0, 1, .., and the total time is 2 u / (a (1 - r)).
struct ImpactCascade {
  double rest_probability;  ///< probability that the motion comes to rest before the next impulse
  double momentum;          ///< sum of the impact speeds over all impacts
  double energy;            ///< sum of the squared impact speeds over all impacts
};
/// @param force_towards_wall the acceleration towards the wall, > 0
ImpactCascade impact_cascade(double speed, double force_towards_wall, double restitution,
                             double impulse_rate);

}  // namespace fpkcheck::fd_fpk
