#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

#include "mcs/simulation/simulation.hpp"

namespace fpkcheck::mcs {

inline constexpr std::string_view kCheckpointFormatLine = "fpkcheck mcs checkpoint 7\n";

/// Returns a text that identifies a simulation by all inputs that determine its results, except the
/// duration. The fingerprint of a simulation states numbers with full precision.
std::string simulation_fingerprint(const problem::Problem& problem, const SimulationPlan& plan,
                                   const ImportanceSplitting* splitting);

/// Writes the state of a simulation to a checkpoint file, by renaming a complete temporary file.
/// Write errors of checkpoint files do not end the simulation.
class CheckpointWriter {
 public:
  /// @param path checkpoint file; if empty, no checkpoints are written
  /// @param warn receives a one-line message after the first of consecutive write errors, and after
  /// a write error of the final checkpoint
  /// @throws InputError if the path cannot be written
  CheckpointWriter(std::string path, std::function<void(const std::string&)> warn);

  /// Writes a checkpoint file, if the path of the checkpoint file is not empty.
  void write_checkpoint_now(const std::string& fingerprint, const Simulation& simulation);
  /// Writes a checkpoint if the last checkpoint is more than 30 s old.
  void write_checkpoint_when_due(const std::string& fingerprint, const Simulation& simulation);
  /// Writes the checkpoint at the end of a simulation, and always reports a write error.
  void write_final_checkpoint(const std::string& fingerprint, const Simulation& simulation);

 private:
  using Clock = std::chrono::steady_clock;

  void try_write_checkpoint(const std::string& fingerprint, const Simulation& simulation);

  std::string path_;
  std::function<void(const std::string&)> warn_;
  Clock::time_point written_{};
  std::string failure_{};  ///< error message of the last write; empty after success
};

/// Sets a simulation to the state in a checkpoint with the given fingerprint.
/// @throws InputError if the file cannot be read, is damaged or belongs to another simulation
void read_checkpoint(const std::string& path, const std::string& fingerprint,
                     Simulation& simulation);

}  // namespace fpkcheck::mcs
