#pragma once

#include <string>

#include "mcs/simulation.hpp"

namespace fpkcheck::mcs {

/// What decides every number of a simulation but how long it goes on: problem, seed, streams,
/// lengths of steps and rounds, bins, thresholds. As text, numbers in full.
std::string fingerprint(const problem::Problem& problem, const Plan& plan,
                        const Splitting* splitting);

/// Writes the simulation's state beside the file and then renames it, so that there is never half a
/// file.
/// @throws InputError when it cannot be written
void write_checkpoint(const std::string& path, const std::string& fingerprint,
                      const Simulation& simulation);

/// Sets a simulation to a state that was written with the same fingerprint: it goes on as if it had
/// never been interrupted.
/// @throws InputError on one line: the file, and that it cannot be read, is damaged, or belongs to
/// another simulation
void read_checkpoint(const std::string& path, const std::string& fingerprint,
                     Simulation& simulation);

}  // namespace fpkcheck::mcs
