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

/// Independent trajectories from a common random start, watched at given times: what a transient
/// solution of a density equation is compared with.
struct EnsembleOptions {
  /// Deviations of z and z' at t = 0: independent Gaussians of mean zero, folded to y >= 0.
  double start_displacement = 0;
  double start_velocity = 0;
  std::vector<double> times{};  ///< increasing, from 0 or later
  std::uint32_t trajectories = 100000;
  std::uint64_t seed = 1;
  /// Automatic: one per processor. The results do not depend on it.
  std::optional<int> threads{};
  /// Bin edges for the marginals, increasing; empty for none.
  std::vector<double> y_edges{};
  std::vector<double> v_edges{};
};

/// The ensemble at one time.
struct EnsembleSnapshot {
  double time = 0;
  transform::Moments moments{};
  transform::Moments standard_errors{};
  /// Bin averages with 95 % intervals, normalised by all trajectories; empty without edges.
  transform::Marginal y{};
  transform::Marginal v{};
};

/// Simulates the impact system itself, paper (1)-(2), from t = 0, each trajectory from random
/// numbers of its own. The same seed gives the same result for any number of threads.
/// @throws InputError on one line: the option, its value and what is allowed
std::vector<EnsembleSnapshot> simulate_ensemble(const problem::Problem& problem,
                                                const EnsembleOptions& options);

}  // namespace fpkcheck::mcs
