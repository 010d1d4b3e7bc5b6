#pragma once

#include <optional>
#include <vector>

#include "fd_fpk/characteristics/flow.hpp"
#include "fd_fpk/operator/grid.hpp"

namespace fpkcheck::fd_fpk {

/// A cell and a part of what is at rest.
struct CellShare {
  int cell;
  double share;
};

/// Where the motion comes to rest: in a stable equilibrium, which it turns about for ever, or in
/// contact with a wall to which the force presses it, after infinitely many impacts in a finite time
/// (there the law has an atom).
struct RestPlace {
  double y;
  std::optional<Side> contact = {};  ///< with this wall
  /// The innermost cells. What is left of the motion about an equilibrium is spread over them as the
  /// time that it spends there; what begins in them in contact comes to rest.
  std::vector<CellShare> cells = {};
  /// Below it no motion leaves these cells; unused in contact.
  double least_energy = 0;
  /// Impacts per unit time of the mass at rest in an equilibrium at a wall.
  double impact_rate = 0;
};

/// All places of rest, by increasing y, with their cells.
/// @param rate of the impulses
std::vector<RestPlace> rest_places(const Flow& flow, const Grid& grid, double rate);

/// Where they are, without cells.
std::vector<RestPlace> rest_places(const Flow& flow);

/// Where cells cease to shrink towards an equilibrium, of the usual amplitude A. Its innermost cells
/// spread what is at rest: with an impulse in few decay times that is most of the mass, while the
/// deviation s and the mean are small against A, as the square root of the impulses per decay time
/// and as these themselves, (s / A)^2. The cells are a thousandth of the mean, and narrower than the
/// narrowest bins next to 0, 8e-4 s (compare/axes.cpp).
double core_at_rest(double deviation, double usual_amplitude);

/// What becomes of a motion of this speed off the wall to which it is pressed, where the force is as
/// good as constant: speeds r^n u, in a time of 2 u / (a (1 - r)).
struct Cascade {
  double survival;  ///< probability that it comes to rest before the next impulse
  double momentum;  ///< sum of the speeds into the wall, of all impacts
  double energy;    ///< of their squares
};
/// @param pressing the acceleration towards the wall, > 0
Cascade cascade(double speed, double pressing, double restitution, double rate);

}  // namespace fpkcheck::fd_fpk
