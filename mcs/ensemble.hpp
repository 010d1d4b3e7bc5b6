#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "transform/density.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::problem {
struct Problem;
}

namespace fpkcheck::mcs {

/// Options of an ensemble: independent trajectories whose initial states have one law, observed at
/// fixed times. The ensemble is the reference for transient solutions of a density equation.
struct EnsembleOptions {
  /// Standard deviations of z and z' at t = 0: independent Gaussians of mean zero, folded to y >=
  /// 0.
  double start_displacement = 0;
  double start_velocity = 0;
  std::vector<double> times{};  ///< times of observation, increasing, the first time 0 or later
  std::uint32_t trajectories = 100000;
  std::uint64_t seed = 1;
  /// Number of threads. Default: one per processor. The results are independent of this number.
  std::optional<int> threads{};
  /// Bin edges of the marginal densities, increasing. If empty, no marginal is estimated.
  std::vector<double> y_edges{};
  std::vector<double> v_edges{};
};

/// Statistics of the ensemble at one time.
struct EnsembleSnapshot {
  double time = 0;
  transform::Moments moments{};
  transform::Moments standard_errors{};
  /// Marginal densities as bin averages with 95 % intervals, normalised by the number of all
  /// trajectories; empty without edges.
  transform::Marginal y{};
  transform::Marginal v{};
};

/// Simulates an ensemble of the impact system, paper (1)-(2), from t = 0, and returns the
/// statistics at each of the times. Each trajectory has its own random numbers. A seed gives the
/// same result for any number of threads.
/// @throws InputError in one line: the option, its value and the allowed range
std::vector<EnsembleSnapshot> simulate_ensemble(const problem::Problem& problem,
                                                const EnsembleOptions& options);

}  // namespace fpkcheck::mcs
