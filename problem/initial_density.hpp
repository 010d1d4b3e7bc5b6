#pragma once

#include <optional>

#include "problem/motion_scales.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Gaussian density of independent displacement and velocity. Between walls the density is truncated
/// and normalised to mass 1.
struct Gaussian {
  double displacement_deviation, velocity_deviation;
  double mean_displacement = 0, mean_velocity = 0;
};

/// Initial density of a computation over time, in physical coordinates.
struct InitialDensityOptions {
  /// Standard deviations of y and y'; automatic: half of the standard deviations of MotionScales.
  std::optional<double> displacement_deviation = {}, velocity_deviation = {};
  /// Means. The automatic mean velocity is 0. The automatic mean displacement is at the wall for the
  /// paper's oscillator, otherwise at the centre of MotionScales.
  std::optional<double> mean_displacement = {}, mean_velocity = {};
};

/// Returns the initial density in the coordinates of the problem.
/// @param problem problem in wall coordinates
/// @throws InputError if the mean displacement is behind a wall
Gaussian initial_density(const Problem& problem, const MotionScales& scales,
                         const InitialDensityOptions& options);

}  // namespace fpkcheck::problem
