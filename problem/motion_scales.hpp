#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::problem {

class EnergyAveraging;

/// Characteristic scales of the stationary motion, in the coordinates of the problem. From the
/// characteristic scales, methods choose grids, axes, initial conditions and burn-in times.
struct MotionScales {
  /// Approximate mean E[y] of the displacement; for the paper's oscillator the static deflection.
  double centre = 0;
  /// Approximate standard deviation of y; for the paper's oscillator the standard deviation of z,
  /// paper (25).
  double displacement_deviation = 0;
  double velocity_deviation = 0;
  /// Ends of the interval of the displacement y: walls, or points outside which the density is
  /// below exp(-7^2/2) times its peak.
  double y_low = 0, y_high = 0;
  double v_high = 0;     ///< speed beyond which the density is below exp(-7^2/2) times its peak
  double frequency = 0;  ///< mean angular frequency of the undamped motion
  /// Decay rate per unit time of the slowest deviation of a density from the stationary density.
  double slowest_decay_rate = 0;
};

/// Computes the motion scales of a problem, by equivalent linearisation for the paper's oscillator
/// and by energy averaging for all other problems. Energy averaging applies to multiple potential
/// wells, limit cycles and two walls.
MotionScales motion_scales(const Problem& problem);

/// Computes the motion scales of a problem from the energy averaging of the problem.
/// @pre the motion is confined: averaging.reason_for_unconfined_motion() is empty
MotionScales scales_from_energy_averaging(const Problem& problem, const EnergyAveraging& averaging);

/// Returns the fraction 1 - exp(-slowest_decay_rate T) of the slowest deviation from the stationary
/// density that decays in the time T.
double decayed_fraction(const MotionScales& scales, double time);

/// Returns the mean number of impulses in the time in which the slowest deviation from the
/// stationary density decays by a factor e; 0 without impulses.
double impulses_per_decay_time(const Problem& problem, const MotionScales& scales);

}  // namespace fpkcheck::problem
