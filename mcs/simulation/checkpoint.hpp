#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "mcs/simulation/simulation.hpp"

namespace fpkcheck::mcs {

/// What decides every number of a simulation but how long it goes on: problem, seed, streams,
/// lengths of steps and rounds, bins, thresholds. As text, numbers in full.
std::string fingerprint(const problem::Problem& problem, const Plan& plan,
                        const Splitting* splitting);

/// Writes the state of a simulation to a file, beside it first and then renamed, so that there is
/// never half a file. What cannot be written does not end the simulation.
class CheckpointWriter {
 public:
  /// @param path empty: nothing is written
  /// @param warn told in one line when a checkpoint could not be written and the one before could,
  ///        and when the last one could not
  /// @throws InputError when nothing could be written there
  CheckpointWriter(std::string path, std::function<void(const std::string&)> warn);

  void write(const std::string& fingerprint, const Simulation& simulation);
  /// Half a minute after the one before.
  void write_when_due(const std::string& fingerprint, const Simulation& simulation);
  void write_last(const std::string& fingerprint, const Simulation& simulation);

 private:
  using Clock = std::chrono::steady_clock;

  void attempt(const std::string& fingerprint, const Simulation& simulation);

  std::string path_;
  std::function<void(const std::string&)> warn_;
  Clock::time_point written_{};
  std::string failure_{};  ///< of the last one; empty when it is written
};

/// Sets a simulation to a state that was written with the same fingerprint: it goes on as if it had
/// never been interrupted.
/// @throws InputError on one line: the file, and that it cannot be read, is damaged, or belongs to
/// another simulation
void read_checkpoint(const std::string& path, const std::string& fingerprint,
                     Simulation& simulation);

}  // namespace fpkcheck::mcs
