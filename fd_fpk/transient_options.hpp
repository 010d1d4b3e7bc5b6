#pragma once

#include <functional>
#include <optional>

#include "fd_fpk/options.hpp"

namespace fpkcheck::fd_fpk {

/// What to integrate over time, and how accurately. Times in the units of the problem.
struct TransientOptions {
  double until = 0;    ///< T > 0
  int snapshots = 50;  ///< N: densities are kept at t = 0, T/N, .. T
  /// Deviations of y and y' in the Gaussian to start from; automatic: half of those of
  /// problem::Scales.
  std::optional<double> start_displacement{};
  std::optional<double> start_velocity{};
  /// Its middle; automatic: in the paper's class the wall (the Gaussian is that of z and z'), else
  /// the centre of problem::Scales, and no velocity.
  std::optional<double> start_mean_displacement{};
  std::optional<double> start_mean_velocity{};
  /// Local error of a step, relative to the largest density.
  double relative_tolerance = 1e-6;
  /// Highest order of BDF, 1 .. 5. Only up to 2 is it stable on the whole imaginary axis, close to
  /// which the eigenvalues of the turning oscillator lie.
  int max_order = 2;
  /// Told the fraction of the time that is done; may be empty.
  std::function<void(double)> progress{};
};

/// The options as files and the command line name them; all of them belong to --until.
const base::Description<TransientOptions>& transient_description();

/// @throws InputError on the first option that cannot be used for a density over time
void validate(const Options& options, const TransientOptions& transient);

}  // namespace fpkcheck::fd_fpk
