#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Properties of a problem that decide which solvers are applicable.
struct ProblemFeatures {
  bool is_paper_oscillator = false;  ///< result of is_paper_oscillator(problem)

  bool no_wall = false, two_walls = false;
  /// Whether the restoring force is nonzero at a wall. The equilibrium then lies at a distance from
  /// the wall, or the force presses the mass against the wall.
  bool offset_wall = false;
  /// Whether the force presses the mass against a wall with r < 1 and there is no noise. After a
  /// sequence of impacts the mass is then at rest in contact until the next impulse, and the
  /// stationary law has an atom at the wall.
  bool rests_in_contact = false;
  /// Whether inelastic collapse occurs: there is noise, and r <= exp(-pi / sqrt 3) at a wall
  /// (problem/inelastic_collapse.hpp).
  bool collapse = false;
  bool noise = false, impulses = true;
  bool constant_damping = true;   ///< whether the damping force is f = c y'
  bool negative_damping = false;  ///< whether c or another coefficient of f is negative
  int wells = 1;  ///< number of minima of U - lambda E[Y] y, minima at walls included
};

ProblemFeatures features(const Problem& problem);

/// Whether the problem has the paper's oscillator, for which equivalent
/// linearisation holds (problem/equivalent_linearisation.hpp). The function reads only the
/// coefficients and does not search for minima of the potential, unlike features().
bool is_paper_oscillator(const Problem& problem);

}  // namespace fpkcheck::problem
