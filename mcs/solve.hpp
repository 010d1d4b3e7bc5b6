#pragma once

#include "mcs/options.hpp"
#include "mcs/summary.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::problem {
struct Problem;
}

namespace fpkcheck::mcs {

struct SimulationResult {
  /// Joint density as a GridDensity from the histogram, and the marginal densities of y and y' on
  /// the bin edges of the histogram, with 95 % confidence intervals. The estimated densities are
  /// normalised by the number of all samples: their mass is 1 minus the fraction of samples outside
  /// the histogram. Estimated moments are averages over samples, not moments of the histogram.
  transform::Solution solution;
  SimulationSummary summary;
};

/// Simulates `options.streams` independent realisations and averages the realisations with the
/// weights of TrajectoryStreamWeights. The burn-in of a realisation is 20 decay times of the
/// slowest mode. For an oscillator with is_duffing_at_wall(), the initial states follow the
/// Gaussian of equivalent linearisation, folded to y >= 0. For other oscillators the initial states
/// follow the energy-averaged density, with the mass of each potential well (InitialStateSampler).
///
/// Problems, densities, marginal densities and atoms are in wall coordinates (problem/walls.hpp).
/// Moments, quantiles and crossing levels are in physical coordinates.
///
/// The random seed determines the result of the simulation bit for bit, for any number of threads,
/// SIMD lanes and interruptions. The solution has the status not_converged if the simulation ends
/// before its requested accuracy, or if the burn-in is below 5 decay times (ShortBurnInCause). The
/// solution has the status failed, without a density, for white noise with a restitution
/// coefficient at which impacts accumulate (problem/problem_features.hpp).
/// @throws InputError as make_simulation_plan(), and for a checkpoint file that cannot be read or
/// written
SimulationResult simulate_stationary_density(const problem::Problem& problem,
                                             const SimulationOptions& options);

/// Sets the status `inaccurate` if the 99 % quantile of the L1 sampling error of a solution with
/// the status `ok` exceeds SimulationOptions::accuracy. With SimulationOptions::controlled,
/// control_variates::simulate_with_control_variates() calls require_accuracy() after the estimates
/// in smooth bins; otherwise simulate_stationary_density() calls require_accuracy().
void require_accuracy(const SimulationOptions& options, transform::Solution& solution);

/// Throws an exception if simulate_stationary_density() would refuse the options or the problem.
/// require_valid_simulation() does not check checkpoint files.
/// @throws InputError as simulate_stationary_density()
void require_valid_simulation(const problem::Problem& problem, const SimulationOptions& options);

}  // namespace fpkcheck::mcs
