#pragma once

#include <optional>
#include <vector>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/characteristics/deterministic_motion.hpp"

namespace fpkcheck::fd_fpk {

/// Index of a grid cell, and the fraction of the mass at a rest point that the cell contains.
struct RestMassFractionInCell {
  int cell;
  double share;
};

/// Rest point of the motion: a stable equilibrium, or contact with a wall against which the force
/// presses the oscillator. Motion approaches an equilibrium but never reaches the equilibrium in
/// finite time. Rest in contact with a wall begins after infinitely many impacts in a finite time,
/// and the stationary law has an atom at the point of contact.
struct RestPoint {
  double y;
  std::optional<WallSide> contact = {};  ///< wall of the contact; empty for an equilibrium
  /// Innermost grid cells around a rest point of the motion. The mass in slow motion about an
  /// equilibrium is distributed over the innermost cells in proportion to the time that the motion
  /// spends in each cell. Motion that starts in the innermost cells around a rest point in contact
  /// with a wall comes to rest.
  std::vector<RestMassFractionInCell> cells = {};
  /// Energy below which motion does not leave the innermost grid cells of an equilibrium
  double escape_energy = 0;
  /// Impacts per unit time of the residual slow motion at an equilibrium located at a wall
  double impact_rate = 0;
};

/// Returns all rest points of the deterministic motion in the order of increasing displacement y,
/// with the innermost grid cells of each rest point.
/// @param impulse_rate arrival rate of impulses, per unit time
std::vector<RestPoint> find_rest_points(const DeterministicFlow& flow, const PhasePlaneGrid& grid,
                                        double impulse_rate);

/// Returns all rest points of the deterministic motion in the order of increasing displacement y,
/// without innermost grid cells.
std::vector<RestPoint> find_rest_points(const DeterministicFlow& flow);

/// Returns the largest rate at which the motion contracts areas of the phase plane near its
/// equilibria. For a motion without rest points, the function returns the mean contraction rate
/// along a limit cycle. If impulses arrive at a lower rate than the contraction rate, the
/// stationary density is unbounded.
double contraction_rate_of_attractors(const DeterministicFlow& flow);

/// Returns the distance to an equilibrium, relative to the typical amplitude A, below which the
/// grid cells have a constant width. Under rare impulses most of the mass is at rest in the
/// innermost cells. Under rare impulses the mean displacement is proportional to s^2 / A, with the
/// standard deviation s of the displacement and the typical amplitude A. The width of the cells
/// near the equilibrium is a thousandth of the mean displacement. The narrowest bins for the
/// comparison of methods have the width 8e-4 s (compare/comparison_bins.cpp), with the standard
/// deviation s, and are wider than the cells near the equilibrium.
double uniform_cell_radius_at_rest_point(double deviation, double typical_amplitude);

/// Cascade of impacts by which motion that starts at a wall comes to rest in contact. During the
/// cascade of impacts the acceleration a towards the wall is nearly constant. With the start speed
/// u and the restitution coefficient r, the impact speeds are r^n u, n = 0, 1, .., and the cascade
/// of impacts lasts 2 u / (a (1 - r)).
struct ImpactCascade {
  double rest_probability;  ///< probability that the motion comes to rest before the next impulse
  double momentum;          ///< sum of the impact speeds over all impacts
  double energy;            ///< sum of the squared impact speeds over all impacts
};
/// @param force_towards_wall acceleration towards the wall, > 0
ImpactCascade impact_cascade(double speed, double force_towards_wall, double restitution,
                             double impulse_rate);

}  // namespace fpkcheck::fd_fpk
