#pragma once

#include "mcs/options.hpp"
#include "mcs/summary.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::problem {
struct Problem;
}

namespace fpkcheck::mcs {

/// A simulated density and the statistics of its simulation.
struct Result {
  /// The joint histogram as a GridDensity, and the marginal densities of y and y' on the same edges
  /// with 95 % intervals. The densities are normalised by the number of all samples: `mass` is 1
  /// minus the fraction of samples outside the histogram. Moments are sample averages, not moments
  /// of the histogram. The expected L1 sampling error of a marginal is the sum over bins of
  /// sqrt(2/pi) * standard error * width.
  transform::Solution solution;
  Summary summary;
};

/// Simulates `options.streams` independent realisations and averages them with the weights of
/// StreamWeights. The burn-in of a realisation is 20 decay times of the slowest mode. The initial
/// states follow the Gaussian of equivalent linearisation, folded to y >= 0, if
/// is_duffing_at_wall(), else the energy-averaged law, with the mass of each well
/// (InitialStateSampler).
///
/// Problems, densities, marginal densities and atoms are in wall coordinates (problem/walls.hpp).
/// Moments, quantiles and crossing levels are in physical coordinates.
///
/// A seed gives the same result, bit for bit, for any number of threads, SIMD lanes and
/// interruptions. The status is not_converged if the simulation ends before its goal, or if the
/// burn-in is below 5 decay times (ShortBurnInCause). The status is failed, without a density, for
/// white noise with a restitution coefficient at which impacts accumulate
/// (problem/features.hpp).
/// @throws InputError as make_simulation_plan(); for a checkpoint file that cannot be read, or could
///        never be written
Result solve(const problem::Problem& problem, const Options& options);

/// Sets the status `inaccurate` if the 99 % quantile of the L1 sampling error of an ok solution
/// exceeds Options::accuracy. solve() calls this function, except with Options::controlled. With
/// this option control_variates::solve() calls it after the estimates in smooth bins.
void require_accuracy(const Options& options, transform::Solution& solution);

/// Makes the checks of options and problem that solve() makes before the simulation begins, except
/// those of checkpoint files.
/// @throws InputError as solve()
void require_solvable(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::mcs
