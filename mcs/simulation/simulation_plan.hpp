#pragma once

#include <cstdint>
#include <optional>

#include "mcs/impulses/excitation.hpp"
#include "mcs/motion/oscillator.hpp"
#include "mcs/options.hpp"
#include "mcs/streams/histogram.hpp"
#include "problem/problem.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::mcs {

/// Default limit of the Taylor step in radians. The errors of the flights are below those of the
/// classical Runge-Kutta method with step 0.05 (docs/simulation.md).
inline constexpr double kAutomaticStep = 0.9;

/// Cause of a burn-in below 5 decay times.
enum class ShortBurnInCause {
  none,      ///< the burn-in leaves exp(-5) of the initial deviation, or less
  impulses,  ///< frequent impulses
  wells,     ///< rare transitions between wells
  decay      ///< weak damping
};

/// All parameters of a simulation, with the default values computed.
struct SimulationPlan {
  int streams;
  int threads;
  std::uint64_t seed;
  problem::Frame frame;  ///< maps the results to physical coordinates
  Oscillator oscillator;
  NoiseKicks kicks;
  double step;
  double burn_in;
  ShortBurnInCause short_burn_in_cause;
  double sampling_interval;
  /// Number of samples of each stream per round.
  std::uint64_t samples_per_round;
  std::uint64_t rounds;           ///< upper limit of the number of rounds
  double centre;                  ///< problem::MotionScales::centre
  double displacement_deviation;  ///< sigma_1 of equivalent linearisation, or of energy averaging
  double velocity_deviation;      ///< sigma_2
  bool has_contact_atoms;         ///< whether the stationary law has atoms at rest in contact
  Excitation excitation;
  BinFinder y_bins;
  BinFinder v_bins;
  std::optional<DepositPlan> deposit{};

  /// Simulated time of one stream per round.
  double round_time() const { return static_cast<double>(samples_per_round) * sampling_interval; }

  const BinFinder& bin_finder(transform::Variable variable) const {
    return variable == transform::Variable::y ? y_bins : v_bins;
  }
};

/// @throws InputError as validate(), and for options that are not supported for the problem
SimulationPlan make_simulation_plan(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::mcs
