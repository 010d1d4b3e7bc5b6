#pragma once

#include <vector>

#include "control_variates/checks.hpp"
#include "control_variates/combine.hpp"
#include "control_variates/prepared.hpp"
#include "mcs/solve.hpp"

namespace fpkcheck::control_variates {

/// A simulation with its control functions, and what they tell together.
struct Result {
  Estimates estimates;
  Checks checks;
  mcs::Result simulation;  ///< with the deposits taken out
  std::vector<double> backward_means;
};

/// Estimates and checks from what a simulation has deposited on prepared.places.grid.
Result combined(const Prepared& prepared, mcs::Result simulation);

}  // namespace fpkcheck::control_variates
