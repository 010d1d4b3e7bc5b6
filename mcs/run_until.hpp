#pragma once

#include <string>

#include "mcs/options.hpp"
#include "mcs/simulation/checkpoint.hpp"
#include "mcs/simulation/simulation.hpp"

namespace fpkcheck::mcs {

/// How a simulation ended.
struct RunOutcome {
  std::string
      unreached_reason{};    ///< why the goal was not reached, in one sentence; empty where it was
  bool interrupted = false;  ///< by Options::stop
};

/// Simulates round by round until the requested time, samples or error are reached, or until
/// Options::stop returns true. Writes checkpoints and reports progress between rounds.
/// @param fingerprint of the checkpoints
RunOutcome run_until(Simulation& simulation, const Options& options, CheckpointWriter& checkpoints,
                     const std::string& fingerprint);

}  // namespace fpkcheck::mcs
