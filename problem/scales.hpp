#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Characteristic scales of the stationary motion, from which boxes, cells, axes, initial
/// conditions and burn-in times are chosen. In the coordinates of the problem.
struct Scales {
  /// Approximately E[y]; in the paper's class the static deflection.
  double centre = 0;
  double displacement_deviation = 0;  ///< of y; in the paper's class of z, paper (25)
  double velocity_deviation = 0;
  /// Walls, or points beyond which the density is below exp(-7^2/2) of its peak.
  double y_low = 0, y_high = 0;
  double v_high = 0;     ///< likewise for the speed
  double frequency = 0;  ///< mean angular frequency of the undamped motion
  /// Decay rate of the slowest deviation from the stationary density, per unit time.
  double slowest_decay_rate = 0;
};

/// Scales by equivalent linearisation in the paper's class (problem/equivalent_linearisation.hpp),
/// on which its published results and the map of validity are based. Otherwise by energy averaging
/// (problem/energy_averaging.hpp), for any wells, limit cycles and walls.
Scales scales(const Problem& problem);

/// Mean number of impulses in the time in which the slowest deviation decays by a factor e; see
/// equivalent_linearisation.hpp. 0 without impulses.
double impulses_per_decay_time(const Problem& problem, const Scales& scales);

}  // namespace fpkcheck::problem
