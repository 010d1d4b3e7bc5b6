#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// A half-cycle of the undamped motion at one energy, given by the two ends of its interval of y.
struct HalfCycle {
  double left, right;      ///< turning points, or walls
  bool at_left, at_right;  ///< whether the left or right end is a wall
};

/// Integrals over one period of an undamped orbit with energy h = v^2/2 + V(y).
struct OrbitIntegrals {
  HalfCycle half_cycle;
  double period = 0;            ///< period T = closed integral of dy / v
  double action = 0;            ///< closed integral of v dy
  double loss = 0;              ///< closed integral of f dy, plus (1 - r^2) u^2 / 2 at each wall
  double time_integral_y = 0;   ///< T times the mean of y over the period
  double time_integral_y2 = 0;  ///< T times the mean of y^2
  double time_integral_damping = 0;  ///< T times the mean of c(y) + c_vv v^2
};

/// The effective potential V = U - lambda E[Y] y: the potential of the spring plus that of the mean
/// force of the impulses.
numerics::Polynomial effective_potential(const Problem& problem);

/// The points between the walls where a polynomial changes its sign, increasing. For V' these
/// points are the extrema of V.
std::vector<double> sign_changes_between_walls(const numerics::Polynomial& polynomial,
                                               const System& system);

/// The orbits of the undamped motion in the effective potential, without noise and with elastic
/// impacts at the walls.
class UndampedOrbits {
 public:
  explicit UndampedOrbits(const Problem& problem);

  const numerics::Polynomial& potential() const { return potential_; }
  /// The positions of the minima of V, increasing. A wall against which the effective force presses
  /// the mass is a minimum too.
  const std::vector<double>& minima() const { return minima_; }
  /// The position of the minimum with the lowest V. @pre is_confining()
  double deepest_minimum() const;
  double lowest_potential() const { return potential_(deepest_minimum()); }

  /// Whether the motion is confined on the left side, on the right side, or on both sides: there is
  /// a wall, or V increases without bound.
  bool is_confining_on_left() const;
  bool is_confining_on_right() const;
  bool is_confining() const { return is_confining_on_left() && is_confining_on_right(); }

  /// All half-cycles with this energy, from left to right. @pre is_confining()
  std::vector<HalfCycle> half_cycles(double energy) const;
  OrbitIntegrals orbit_integrals(const HalfCycle& half_cycle, double energy) const;

 private:
  double half_cycle_end(double knot, double outwards, double energy) const;

  const System system_;
  numerics::Polynomial potential_;
  std::vector<double> extrema_;  // extrema of V, increasing
  std::vector<double> minima_;
};

}  // namespace fpkcheck::problem
