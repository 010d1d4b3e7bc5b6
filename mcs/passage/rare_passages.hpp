#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "mcs/passage/level_crossings.hpp"
#include "mcs/simulation/simulation_plan.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {

/// Passages in one independent replication of the splitting (simulate_rare_passages()).
struct RarePassages {
  double weight = 0;  ///< rate per unit time that each trajectory of the last stage represents
  std::uint64_t crossings = 0;  ///< number of upcrossings
  double time_above = 0;        ///< time between upcrossings and downcrossings
  /// Time above the given barrier, which differs from `time_above` if the barrier is shifted
  double time_above_given_barrier = 0;
  /// Lengths of the stays below the barrier that begin at downcrossings; longer stays have the
  /// length `longest_stay` of simulate_rare_passages()
  std::vector<double> stays = {};
};

struct RarePassageRun {
  /// Replications; empty if the levels do not lead to the barrier, or if the simulated time is too
  /// short
  std::vector<RarePassages> replications = {};
  std::size_t levels = 0;     ///< number of levels
  double simulated_time = 0;  ///< over all streams
};

/// Simulates rare passages above a barrier by multilevel splitting with fixed effort (Garvels, The
/// splitting method in rare event simulation, thesis, Twente 2000). Levels of the energy v^2/2 +
/// V(y) divide the way to the barrier. An excursion begins when the energy of the stationary
/// process rises above the lowest level and ends when the energy falls below the lowest level. In
/// stage 0 a stationary simulation gives the rate of excursions and their initial states. Stage k
/// continues a fixed number of trajectories from the states in which the trajectories of stage k-1
/// reached level k, until level k+1 or the end of the excursion. In the last stage the excursions
/// are simulated to their end. Thus
///
///     rate of passages = rate of excursions * product of the fractions that reach the next level.
///
/// Each replication gives unbiased estimates of all rates. A pilot run chooses the levels, each of
/// which a quarter of the trajectories reaches. A state is compared with the levels at intervals of
/// two samples.
/// @param plan plan of the stationary simulation, whose number of streams is not used
/// @param longest_stay time after a downcrossing at which the simulation of a stay ends
/// @param most_time limit of the simulated time over all streams
/// @param is_precise function of the replications so far, whether no further replications are
/// needed
RarePassageRun simulate_rare_passages(
    const problem::Problem& problem, const SimulationPlan& plan, const PassageLevel& barrier,
    const problem::MotionScales& scales, double longest_stay, double most_time,
    const std::function<bool(const std::vector<RarePassages>&)>& is_precise);

}  // namespace fpkcheck::mcs
