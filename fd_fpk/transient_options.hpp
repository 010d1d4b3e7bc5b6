#pragma once

#include <functional>
#include <optional>

#include "fd_fpk/options.hpp"

namespace fpkcheck::fd_fpk {

/// Options of the density over time. Times are in the units of the problem.
struct TransientOptions {
  double until = 0;    ///< end time T > 0 of the integration
  int snapshots = 50;  ///< number N of intervals: densities are stored at t = 0, T/N, .. T
  /// Standard deviations of y and y' of the initial Gaussian; automatic: half of the standard
  /// deviations of problem::MotionScales.
  std::optional<double> start_displacement{};
  std::optional<double> start_velocity{};
  /// Means of the initial Gaussian; automatic: mean velocity 0, and mean displacement at the wall
  /// for the paper's oscillator (a Gaussian of z and z'), else at the centre of
  /// problem::MotionScales.
  std::optional<double> start_mean_displacement{};
  std::optional<double> start_mean_velocity{};
  /// Tolerance of the local error of a time step, relative to the largest density.
  double relative_tolerance = 1e-6;
  /// Highest order of BDF, 1 .. 5. BDF of an order above 2 is unstable on part of the imaginary
  /// axis, and the eigenvalues of the rotating oscillator lie next to that axis.
  int max_order = 2;
  /// Function that is called with the completed fraction of the integration time; may be empty.
  std::function<void(double)> progress{};
};

/// Names, help texts and ranges of these options, in files and on the command line. All of these
/// options require --until.
const base::Description<TransientOptions>& transient_option_descriptions();

/// @throws InputError for the first option that is invalid for a density over time
void validate(const Options& options, const TransientOptions& transient);

}  // namespace fpkcheck::fd_fpk
