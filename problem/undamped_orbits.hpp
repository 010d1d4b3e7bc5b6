#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// The interval of y between the ends of a half-cycle of the undamped motion at one energy.
struct HalfCycle {
  double left, right;      ///< turning points, or walls
  bool at_left, at_right;  ///< whether this end is a wall
};

/// Integrals over one period of the undamped motion at energy h = v^2/2 + V(y).
struct Orbit {
  HalfCycle half_cycle;
  double period = 0;            ///< T = closed integral of dy / v
  double action = 0;            ///< closed integral of v dy
  double loss = 0;              ///< closed integral of f dy, plus (1 - r^2) u^2 / 2 at each wall
  double time_integral_y = 0;   ///< T times the mean of y over the period
  double time_integral_y2 = 0;  ///< T times the mean of y^2
  double time_integral_damping = 0;  ///< T times the mean of c(y) + c_vv v^2
};

/// The potential V = U - lambda E[Y] y of the spring and of the mean force of the impulses.
numerics::Polynomial effective_potential(const Problem& problem);

/// The sign changes of a polynomial between the walls, increasing; for V' the extrema of V.
std::vector<double> sign_changes_between_walls(const numerics::Polynomial& polynomial,
                                               const System& system);

/// The motion in the effective potential, without damping and fluctuations, elastic at the walls.
class UndampedOrbits {
 public:
  explicit UndampedOrbits(const Problem& problem);

  const numerics::Polynomial& potential() const { return potential_; }
  /// The minima of V, increasing; a wall against which V presses the mass counts as one.
  const std::vector<double>& minima() const { return minima_; }
  /// The minimum with the lowest V. @pre is_confining()
  double deepest_minimum() const;
  double lowest_potential() const { return potential_(deepest_minimum()); }

  /// Whether V grows without bound at the left, right or every end without a wall.
  bool is_confining_on_left() const;
  bool is_confining_on_right() const;
  bool is_confining() const { return is_confining_on_left() && is_confining_on_right(); }

  /// The half-cycles of an energy, from left to right. @pre is_confining()
  std::vector<HalfCycle> half_cycles(double energy) const;
  Orbit orbit(const HalfCycle& half_cycle, double energy) const;

 private:
  double end(double knot, double outwards, double energy) const;

  const System system_;
  numerics::Polynomial potential_;
  std::vector<double> extrema_;  // extrema of V, increasing
  std::vector<double> minima_;
};

}  // namespace fpkcheck::problem
