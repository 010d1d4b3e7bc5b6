#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Characteristic scales of the stationary motion, in the coordinates of the problem. Methods
/// choose the limits of grids, cell widths, axes, initial conditions and burn-in times by these
/// scales.
struct MotionScales {
  /// Approximation of E[y]; for the paper's oscillator, the static deflection.
  double centre = 0;
  /// Standard deviation of y; for the paper's oscillator that of z, paper (25).
  double displacement_deviation = 0;
  double velocity_deviation = 0;
  /// The ends of the interval of y: walls, or points beyond which the density is below exp(-7^2/2)
  /// of its peak.
  double y_low = 0, y_high = 0;
  double v_high = 0;     ///< limit of the speed, by the same criterion
  double frequency = 0;  ///< mean angular frequency of the undamped motion
  /// Decay rate of the slowest deviation from the stationary density, per unit time.
  double slowest_decay_rate = 0;
};

/// Computes the scales of a problem. For the paper's oscillator, the scales are those
/// of equivalent linearisation (problem/equivalent_linearisation.hpp); the published results and
/// the map of validity are based on these scales. For all other problems the scales are computed by
/// energy averaging (problem/energy_averaging.hpp), which treats multiple wells, limit cycles and
/// two walls.
MotionScales scales(const Problem& problem);

/// Mean number of impulses in the time in which the slowest deviation from the stationary density
/// decays by a factor e (problem/equivalent_linearisation.hpp). 0 for a problem without impulses.
double impulses_per_decay_time(const Problem& problem, const MotionScales& scales);

}  // namespace fpkcheck::problem
