#pragma once

#include <functional>
#include <string>

#include "mcs/options.hpp"
#include "methods/method_interface.hpp"

namespace fpkcheck::methods {

/// Settings of a simulation that are not stored in files: checkpoints, interruption and processes.
struct SimulationRuntimeSettings {
  std::string checkpoint = {};  ///< checkpoint file to write; if empty, none is written
  std::string resume = {};      ///< checkpoint file to resume from; empty for a new simulation
  /// Function that returns whether the simulation must stop early and return a partial result.
  std::function<bool()> stop = {};
  std::function<void(const std::string&)> warn = {};  ///< function that receives warnings
  mcs::SimulationProcessGroup process_group = {};     ///< processes that share the simulation
};

/// @param simulation method of the registry entry mcs_solver()
Method simulation_with_runtime_settings(Method simulation,
                                        const SimulationRuntimeSettings& settings);

}  // namespace fpkcheck::methods
