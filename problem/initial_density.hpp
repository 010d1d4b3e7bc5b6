#pragma once

#include <optional>

#include "problem/motion_scales.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Gaussian initial density of independent displacement and velocity. The initial density is
/// truncated at the walls and normalised to mass 1.
struct InitialGaussian {
  double displacement_deviation, velocity_deviation;
  double mean_displacement = 0, mean_velocity = 0;
};

/// Initial density of a computation over time, in physical coordinates.
struct InitialDensityOptions {
  /// Standard deviations of y and y' in the initial density. An absent standard deviation of the
  /// initial density is replaced by half of the stationary standard deviation in MotionScales.
  std::optional<double> displacement_deviation = {}, velocity_deviation = {};
  /// Mean displacement and mean velocity of the initial density. An absent mean velocity is
  /// replaced by 0. An absent mean displacement is replaced by the wall position for the paper's
  /// oscillator, otherwise by the centre in MotionScales.
  std::optional<double> mean_displacement = {}, mean_velocity = {};
};

/// Returns the initial density in the coordinates of the problem.
/// @param problem problem in wall coordinates
/// @throws InputError if the mean displacement is behind a wall
InitialGaussian initial_density(const Problem& problem, const MotionScales& scales,
                                const InitialDensityOptions& options);

/// Range y_low .. y_high of displacements and 0 .. v_high of speeds.
struct StateRange {
  double y_low, y_high, v_high;
};

/// Returns the range of states of the undamped motion from all states within six standard
/// deviations of the mean of an initial density, between the walls. The energy of the undamped
/// motion is v^2/2 + V(y) with the potential V of EffectivePotential.
/// @param problem problem in wall coordinates, with confined motion at any energy
StateRange reachable_state_range(const Problem& problem, const InitialGaussian& density);

}  // namespace fpkcheck::problem
