#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Properties of a problem that decide which solvers are applicable.
struct Features {
  bool is_paper_oscillator = false;  ///< is_paper_oscillator(problem)

  bool no_wall = false, two_walls = false;
  /// The restoring force is not 0 at a wall: there is a gap, or the mass is pressed against the
  /// wall.
  bool offset_wall = false;
  /// The mass is pressed against a wall with r < 1 and there is no noise: impacts end in rest, and
  /// the law has an atom in contact until the next impulse.
  bool rests_in_contact = false;
  /// Under noise with r <= exp(-pi / sqrt 3) at a wall: inelastic collapse
  /// (problem/inelastic_collapse.hpp).
  bool collapse = false;
  bool noise = false, impulses = true;
  bool constant_damping = true;   ///< f = c y'
  bool negative_damping = false;  ///< c or another coefficient of f is negative
  int wells = 1;                  ///< minima of U - lambda E[Y] y, walls included
};

Features features(const Problem& problem);

/// Whether the problem is in the paper's class: one wall, at y = 0 on the left; f = c y' with
/// c > 0; g = k y + mu y^3 with k, mu >= 0; impulses without noise. (In the coordinates of
/// wall_frame.) Decided from the coefficients alone, without the search for minima in features().
bool is_paper_oscillator(const Problem& problem);

}  // namespace fpkcheck::problem
