#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// An interval in which the mass swings at one energy.
struct Swing {
  double left, right;      ///< turning points, or walls
  bool at_left, at_right;  ///< it ends at a wall
};

/// What one period of the undamped motion holds, at energy h = v^2/2 + V(y).
struct Orbit {
  Swing swing;
  double period = 0;        ///< T = closed integral of dy / v
  double action = 0;        ///< closed integral of v dy
  double loss = 0;          ///< closed integral of f dy, and (1 - r^2) u^2 / 2 at each wall
  double time_y = 0;        ///< T times the mean of y over the period
  double time_y2 = 0;       ///< T times that of y^2
  double time_damping = 0;  ///< T times that of c(y) + c_vv v^2
};

/// V = U - lambda E[Y] y: of the spring and of the mean of the impulses.
numerics::Polynomial effective_potential(const Problem& problem);

/// Where a polynomial changes its sign between the walls, increasing; of V' the turns of V.
std::vector<double> sign_changes_between_walls(const numerics::Polynomial& polynomial,
                                               const System& system);

/// The motion without damping and excitation but for the mean of the impulses: in the effective
/// potential, elastic at the walls.
class UndampedOrbits {
 public:
  explicit UndampedOrbits(const Problem& problem);

  const numerics::Polynomial& potential() const { return potential_; }
  /// Where V has a minimum, increasing; a wall to which it presses is one.
  const std::vector<double>& minima() const { return minima_; }
  /// The deepest of them. @pre confined()
  double deepest() const;
  double lowest_potential() const { return potential_(deepest()); }

  /// V grows without bound at every open end.
  bool held_on_the_left() const;
  bool held_on_the_right() const;
  bool confined() const { return held_on_the_left() && held_on_the_right(); }

  /// The intervals of an energy, from left to right. @pre confined()
  std::vector<Swing> swings(double energy) const;
  Orbit orbit(const Swing& swing, double energy) const;

 private:
  double end(double knot, double outwards, double energy) const;

  const System system_;
  numerics::Polynomial potential_;
  std::vector<double> turns_;  // of V, increasing: where V' changes its sign
  std::vector<double> minima_;
};

}  // namespace fpkcheck::problem
