#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "mcs/simulation/simulation.hpp"

namespace fpkcheck::mcs {

/// Text of everything that determines the numbers of a simulation, except its duration: problem,
/// seed, streams, lengths of steps and rounds, bins, thresholds. Numbers have full precision.
std::string fingerprint(const problem::Problem& problem, const Plan& plan,
                        const Splitting* splitting);

/// Writes the state of a simulation to a file, by renaming a complete temporary file. Write errors
/// do not end the simulation.
class CheckpointWriter {
 public:
  /// @param path empty: no checkpoints
  /// @param warn called with one line after the first of consecutive write errors, and after an
  ///        error of the last checkpoint
  /// @throws InputError where the path cannot be written
  CheckpointWriter(std::string path, std::function<void(const std::string&)> warn);

  void write(const std::string& fingerprint, const Simulation& simulation);
  /// Writes a checkpoint if the last one is at least half a minute old.
  void write_when_due(const std::string& fingerprint, const Simulation& simulation);
  void write_last(const std::string& fingerprint, const Simulation& simulation);

 private:
  using Clock = std::chrono::steady_clock;

  void try_write(const std::string& fingerprint, const Simulation& simulation);

  std::string path_;
  std::function<void(const std::string&)> warn_;
  Clock::time_point written_{};
  std::string failure_{};  ///< of the last write; empty after success
};

/// Sets a simulation to the state in a checkpoint of the same fingerprint. The simulation continues
/// as without the interruption.
/// @throws InputError in one line: the file cannot be read, is damaged or belongs to another
///        simulation
void read_checkpoint(const std::string& path, const std::string& fingerprint,
                     Simulation& simulation);

}  // namespace fpkcheck::mcs
