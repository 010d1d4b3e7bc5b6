#pragma once

#include <vector>

#include "control_variates/checks.hpp"
#include "control_variates/control_setup.hpp"
#include "control_variates/estimates.hpp"
#include "mcs/solve.hpp"

namespace fpkcheck::control_variates {

/// Results of a simulation with control variates: estimates, checks and the plain simulation.
struct Result {
  FunctionalEstimates estimates;
  SimulationChecks checks;
  mcs::Result simulation;  ///< without the deposits
  std::vector<double> backward_means;
};

/// Computes estimates and checks from the deposits of a simulation on setup.deposit_layout.grid.
Result make_result(const ControlSetup& setup, mcs::Result simulation);

}  // namespace fpkcheck::control_variates
