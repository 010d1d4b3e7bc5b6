#pragma once

#include <functional>
#include <string>

#include "mcs/options.hpp"
#include "methods/method.hpp"

namespace fpkcheck::methods {

/// Settings of a simulation that are not stored in files: checkpoints, interruption and processes.
struct SimulationRuntimeSettings {
  std::string checkpoint = {};  ///< checkpoint file to write; empty for no checkpoints
  std::string resume = {};      ///< checkpoint file to resume from; empty for a new simulation
  /// Returns whether the simulation must stop and return its result so far.
  std::function<bool()> stop = {};
  std::function<void(const std::string&)> warn = {};  ///< receives warnings about failed writes
  mcs::ProcessGroup process_group = {};               ///< processes that share the simulation
};

/// @param simulation a method of mcs_solver()
Method with_runtime_settings(Method simulation, const SimulationRuntimeSettings& settings);

}  // namespace fpkcheck::methods
