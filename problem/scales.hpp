#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// How large the motion of a problem is and how fast: what boxes, cells, axes, starts and burn-in are
/// made of. In the coordinates of the problem, whatever its walls.
struct Scales {
  double centre = 0;                  ///< about E[y]; the static deflection of the paper's class
  double displacement_deviation = 0;  ///< of y; of z, paper (25), in the paper's class
  double velocity_deviation = 0;
  double y_low = 0,
         y_high = 0;     ///< the density is below exp(-7^2/2) of its peak beyond, or a wall stands
  double v_high = 0;     ///< likewise
  double frequency = 0;  ///< mean angular frequency of the undamped motion
  double slowest_decay = 0;  ///< of any deviation from the stationary density, per unit time
};

/// By equivalent linearisation in the paper's class (problem/equivalent_linearisation.hpp: what its
/// published results and the map of validity stand on), else by energy averaging
/// (problem/energy_averaging.hpp), which holds for wells, rings and walls anywhere.
Scales scales(const Problem& problem);

/// Impulses in the time in which the slowest deviation falls by a factor e; see
/// equivalent_linearisation.hpp. 0 without impulses.
double impulses_per_decay_time(const Problem& problem, const Scales& scales);

}  // namespace fpkcheck::problem
