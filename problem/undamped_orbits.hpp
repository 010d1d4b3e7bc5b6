#pragma once

#include <vector>

#include "problem/effective_potential.hpp"

namespace fpkcheck::problem {

/// A half-cycle of the undamped motion at one energy, from one end of an interval of y to the other
/// end.
struct HalfCycle {
  double left, right;                ///< ends of the interval of y: turning points or walls
  bool left_is_wall, right_is_wall;  ///< whether the left end and the right end are walls
};

/// Integrals over one period of an undamped orbit of the energy h = v^2/2 + V(y).
struct OrbitIntegrals {
  HalfCycle half_cycle;
  double period = 0;  ///< period T = closed integral of dy / v
  double action = 0;  ///< closed integral of v dy
  /// Energy loss over one period: closed integral of (f + D G_v) dy with the damping force f, plus
  /// (1 - r^2) u^2 / 2 at each impact with speed u. The term D G_v of the energy loss, with G =
  /// g^2, exists for noise with a factor g(y, v).
  double loss = 0;
  /// Closed integral of (D G + lambda E[Y^2] b^2/2) v dy: half of the diffusion coefficient of the
  /// energy, multiplied by the period of the orbit.
  double diffusion = 0;
  double time_integral_y = 0;        ///< period T times the orbit mean of y
  double time_integral_y2 = 0;       ///< period T times the orbit mean of y^2
  double time_integral_damping = 0;  ///< period T times the orbit mean of c(y) + c_vv v^2
};

/// The orbits of the undamped motion in the effective potential, without noise and with elastic
/// impacts at the walls.
class UndampedOrbits {
 public:
  explicit UndampedOrbits(const Problem& problem);

  const EffectivePotential& potential() const { return potential_; }
  /// Returns the positions of the minima of the effective potential V, in increasing order. A wall
  /// against which the effective force presses the mass also counts as a minimum.
  const std::vector<double>& potential_minima() const { return minima_; }
  /// Returns the position of the lowest minimum of the effective potential V.
  /// @pre is_confining()
  double deepest_minimum() const;
  double lowest_potential() const { return potential_(deepest_minimum()); }

  /// Return whether a wall, or a potential V that increases without bound, confines the motion on
  /// the left side, on the right side, or on both sides.
  bool is_confining_on_left() const;
  bool is_confining_on_right() const;
  bool is_confining() const { return is_confining_on_left() && is_confining_on_right(); }

  /// Returns all half-cycles of the undamped motion with the given energy, from left to right.
  /// @pre is_confining()
  std::vector<HalfCycle> half_cycles(double energy) const;
  /// Returns the integrals over the undamped orbit of the given energy and half-cycle.
  OrbitIntegrals orbit_integrals(const HalfCycle& half_cycle, double energy) const;

 private:
  double find_turning_point(double knot, double direction, double energy) const;

  const Problem problem_;
  EffectivePotential potential_;
  std::vector<double> minima_;
};

}  // namespace fpkcheck::problem
