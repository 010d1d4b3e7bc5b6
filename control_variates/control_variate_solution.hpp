#pragma once

#include <string>
#include <vector>

#include "control_variates/control_variate_estimates.hpp"
#include "control_variates/control_variate_setup.hpp"
#include "control_variates/simulation_identity_checks.hpp"
#include "mcs/solve.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::control_variates {

struct ControlVariateResult {
  StationaryFunctionalEstimates estimates;
  SimulationIdentityChecks checks;
  mcs::SimulationResult
      simulation;  ///< solution and summary of the simulation, without the deposited sums
  std::vector<double> backward_means;
};

/// Computes estimates with control variates and checks of the simulation from its deposited sums.
/// @pre the simulation used setup.deposit_layout.grid
ControlVariateResult estimate_and_check_simulation(const ControlVariateSetup& setup,
                                                   mcs::SimulationResult simulation);

/// Returns the solution whose moments and averages over smooth bins are estimated by control
/// variates. The estimates without control variates and the results of the checks become metrics of
/// the solution.
transform::Solution solution_estimated_by_control_variates(ControlVariateResult&& result);

/// Adds a note to the solution of a simulation without control variates.
/// @param reason clause of the note: why the simulation uses no control variates
transform::Solution with_note_on_missing_control_variates(transform::Solution&& plain,
                                                          const std::string& reason);

}  // namespace fpkcheck::control_variates
