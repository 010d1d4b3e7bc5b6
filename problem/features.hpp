#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// What a problem has in it that decides which solver can treat it.
struct Features {
  bool original = false;  ///< of_the_paper(problem)

  bool no_wall = false, two_walls = false;
  /// The force is not 0 at a wall: there is a gap, or the mass is pressed against it.
  bool offset_wall = false;
  /// The mass is pressed against a wall with r < 1 and no noise lifts it: impacts end in rest, and the
  /// law has an atom there until the next impulse.
  bool rests_in_contact = false;
  /// Under noise, at some wall r <= exp(-pi / sqrt 3): impacts accumulate
  /// (problem/inelastic_collapse.hpp).
  bool collapse = false;
  bool noise = false, impulses = true;
  bool constant_damping = true;   ///< f = c y'
  bool negative_damping = false;  ///< c < 0, or another coefficient of f is
  int wells = 1;                  ///< minima of U - lambda E[Y] y, walls included
};

Features features(const Problem& problem);

/// The paper's class: a wall at y = 0 on the left alone, f = c y' with c > 0, g = k y + mu y^3 with
/// k, mu >= 0, impulses without noise. (In the frame of frame_of.) Seen from the coefficients: who
/// asks no more need not search for the minima that features() counts.
bool of_the_paper(const Problem& problem);

}  // namespace fpkcheck::problem
