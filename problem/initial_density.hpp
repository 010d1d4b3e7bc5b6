#pragma once

#include <optional>

#include "problem/motion_scales.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Gaussian density of independent displacement and velocity. Between walls the density is
/// truncated and normalised to mass 1.
struct Gaussian {
  double displacement_deviation, velocity_deviation;
  double mean_displacement = 0, mean_velocity = 0;
};

/// Initial density of a computation over time, in physical coordinates.
struct InitialDensityOptions {
  /// Standard deviations of y and y'; automatic: half of the standard deviations of MotionScales.
  std::optional<double> displacement_deviation = {}, velocity_deviation = {};
  /// Means. The automatic mean velocity is 0. The automatic mean displacement is at the wall for
  /// the paper's oscillator, otherwise at the centre of MotionScales.
  std::optional<double> mean_displacement = {}, mean_velocity = {};
};

/// Returns the initial density in the coordinates of the problem.
/// @param problem problem in wall coordinates
/// @throws InputError if the mean displacement is behind a wall
Gaussian initial_density(const Problem& problem, const MotionScales& scales,
                         const InitialDensityOptions& options);

/// Range of displacements and speeds.
struct StateRange {
  double y_low, y_high, v_high;
};

/// Returns the range of the undamped motion from all states within six standard deviations of a
/// Gaussian, between the walls. The energy is v^2/2 + V(y) with the potential V of
/// EffectivePotential.
/// @param problem problem in wall coordinates, in which the motion of any energy is confined
StateRange reachable_states(const Problem& problem, const Gaussian& density);

}  // namespace fpkcheck::problem
