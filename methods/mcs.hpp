#pragma once

#include <functional>
#include <string>

#include "mcs/options.hpp"
#include "methods/method.hpp"

namespace fpkcheck::methods {

/// Checkpoints, interruption and processes of a simulation: settings that files do not store.
struct SimulationControl {
  std::string checkpoint = {};      ///< file to write the state to; empty for none
  std::string resume = {};          ///< file of the checkpoint to resume; empty for none
  std::function<bool()> stop = {};  ///< true ends the simulation and keeps the result so far
  std::function<void(const std::string&)> warn = {};  ///< receives warnings about failed writes
  mcs::Team team = {};                                ///< processes that share the simulation
};

/// The method `simulation` with these settings.
/// @param simulation a method of mcs_solver
Method with_control(Method simulation, const SimulationControl& control);

}  // namespace fpkcheck::methods
