#pragma once

#include <functional>
#include <optional>

#include "fd_fpk/options.hpp"

namespace fpkcheck::fd_fpk {

/// Options of the density over time. Times are in the units of the problem.
struct TransientOptions {
  double until = 0;    ///< end time T > 0
  int snapshots = 50;  ///< N: densities are stored at t = 0, T/N, .. T
  /// Standard deviations of y and y' of the initial Gaussian; automatic: half of those of
  /// problem::Scales.
  std::optional<double> start_displacement{};
  std::optional<double> start_velocity{};
  /// Means of the initial Gaussian; automatic: mean velocity 0, and mean displacement at the wall
  /// in the paper's class (a Gaussian of z and z'), else at the centre of problem::Scales.
  std::optional<double> start_mean_displacement{};
  std::optional<double> start_mean_velocity{};
  /// Tolerance of the local error of a step, relative to the largest density.
  double relative_tolerance = 1e-6;
  /// Highest order of BDF, 1 .. 5. Orders above 2 are unstable on part of the imaginary axis, next
  /// to which the eigenvalues of the rotating oscillator lie.
  int max_order = 2;
  /// Called with the completed fraction of the time; may be empty.
  std::function<void(double)> progress{};
};

/// Names, help texts and ranges of the options, in files and on the command line; all belong to
/// --until.
const base::Description<TransientOptions>& transient_description();

/// @throws InputError for the first option that is invalid for a density over time
void validate(const Options& options, const TransientOptions& transient);

}  // namespace fpkcheck::fd_fpk
