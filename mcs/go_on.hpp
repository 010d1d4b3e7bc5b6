#pragma once

#include <string>

#include "mcs/options.hpp"
#include "mcs/simulation/checkpoint.hpp"
#include "mcs/simulation/simulation.hpp"

namespace fpkcheck::mcs {

/// How a simulation came to its end.
struct Ending {
  std::string unreached{};   ///< why not at what was asked for, in one sentence; empty when there
  bool interrupted = false;  ///< by Options::stop
};

/// Goes on, round by round, until the time, the samples or the error that was asked for is reached
/// or Options::stop says so. Writes checkpoints and tells the progress on the way.
/// @param fingerprint of the checkpoints
Ending go_on(Simulation& simulation, const Options& options, CheckpointWriter& checkpoints,
             const std::string& fingerprint);

}  // namespace fpkcheck::mcs
