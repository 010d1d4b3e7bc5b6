#pragma once

#include <string>

#include "mcs/options.hpp"
#include "mcs/simulation/checkpoint.hpp"
#include "mcs/simulation/simulation.hpp"
#include "mcs/simulation/simulation_plan.hpp"
#include "mcs/streams/importance_splitting.hpp"

namespace fpkcheck::mcs {

/// Chooses the energy thresholds of importance splitting for a problem by pilot simulations with
/// independent random numbers. Each pilot simulation uses the thresholds of the previous pilot
/// simulation and adds thresholds at higher energies. The probability that the energy after an
/// impulse exceeds the last energy threshold is about 1e-10.
ImportanceSplitting choose_splitting_thresholds(const problem::Problem& problem,
                                                const SimulationPlan& plan);

/// Returns whether SimulationOptions::stop requests the end of the simulation. In a simulation by
/// several processes is_simulation_stop_requested() returns false, since all processes must
/// simulate an equal time; a stop request then ends the process.
bool is_simulation_stop_requested(const SimulationOptions& options);

struct SimulationRunOutcome {
  /// Reason why the requested accuracy or number of samples was not reached, in one sentence; empty
  /// if the requested accuracy and number of samples were reached
  std::string unreached_goal_reason{};
  bool interrupted = false;
};

/// Simulates round by round until the requested time, samples or error are reached, or until
/// SimulationOptions::stop returns true. Writes checkpoints and reports progress between rounds.
/// @param fingerprint text that simulation_fingerprint() returns, for the checkpoints
SimulationRunOutcome simulate_until_goal(Simulation& simulation, const SimulationOptions& options,
                                         CheckpointWriter& checkpoints,
                                         const std::string& fingerprint);

}  // namespace fpkcheck::mcs
