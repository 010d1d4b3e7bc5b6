#pragma once

#include <cstdint>
#include <optional>

#include "mcs/impulses/excitation.hpp"
#include "mcs/options.hpp"
#include "mcs/simulation/durations.hpp"
#include "mcs/simulation/general_plan.hpp"
#include "mcs/streams/histogram.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::problem {
struct Problem;
}

namespace fpkcheck::mcs {

/// Radians of the longest flights where nothing else is asked for: errors below those of the
/// classical Runge-Kutta method with step 0.05.
inline constexpr double kAutomaticStep = 0.9;

/// The options with everything automatic filled in.
struct Plan {
  int streams;
  int threads;
  std::uint64_t seed;
  problem::Frame frame;  ///< moments are stated by it
  double step;
  double burn_in;
  BurnInLimit burn_in_limit;
  double sampling_interval;
  /// The simulation goes on in rounds of as many samples of each stream.
  std::uint64_t samples_per_round;
  std::uint64_t rounds;           ///< at most
  double displacement_deviation;  ///< sigma_1 of the Gaussian to start from
  double velocity_deviation;      ///< sigma_2
  Excitation excitation;
  BinFinder y_bins;
  BinFinder v_bins;
  std::optional<DepositPlan> deposit{};
  /// Of an oscillator that is not the paper's: it is moved by GeneralMotion.
  std::optional<GeneralPlan> general{};

  /// Measured time of one stream in a round.
  double round_time() const { return static_cast<double>(samples_per_round) * sampling_interval; }

  const BinFinder& bins(transform::Variable variable) const {
    return variable == transform::Variable::y ? y_bins : v_bins;
  }
};

/// @throws InputError as validate() and make_general_plan()
Plan make_plan(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::mcs
