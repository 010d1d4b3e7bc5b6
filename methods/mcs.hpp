#pragma once

#include <functional>
#include <string>

#include "mcs/options.hpp"
#include "methods/method.hpp"

namespace fpkcheck::methods {

/// How a simulation is followed, interrupted and resumed: what is no part of its options in files.
struct SimulationControl {
  std::string checkpoint = {};      ///< file to write the state to; empty for none
  std::string resume = {};          ///< file of a checkpoint to go on from; empty for none
  std::function<bool()> stop = {};  ///< true ends it, with what was reached as the result
  std::function<void(const std::string&)> warn = {};  ///< told of what could not be written
  mcs::Team team = {};                                ///< processes that share it
};

/// The same simulation under control.
/// @param simulation a method of mcs_solver
Method under_control(Method simulation, const SimulationControl& control);

}  // namespace fpkcheck::methods
