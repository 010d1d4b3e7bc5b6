#pragma once

#include <cstdint>
#include <optional>

#include "mcs/histogram.hpp"
#include "mcs/impulse_source.hpp"
#include "mcs/simulate.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {

/// The options with everything automatic filled in.
struct Plan {
  int streams;
  int threads;
  std::uint64_t seed;
  double step;
  double burn_in;
  double sampling_interval;
  /// The simulation goes on in rounds of as many samples of each stream.
  std::uint64_t samples_per_round;
  std::uint64_t rounds;           ///< at most
  double displacement_deviation;  ///< sigma_1 of the Gaussian to start from
  double velocity_deviation;      ///< sigma_2
  Excitation excitation;
  BinFinder y_bins;
  BinFinder v_bins;

  /// Measured time of one stream in a round.
  double round_time() const { return static_cast<double>(samples_per_round) * sampling_interval; }
};

/// @throws InputError as validate()
Plan make_plan(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::mcs
