#pragma once

#include <string>
#include <vector>

#include "control_variates/checks.hpp"
#include "control_variates/control_setup.hpp"
#include "control_variates/estimates.hpp"
#include "mcs/solve.hpp"
#include "transform/solution.hpp"

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

/// The solution of a simulation with control variates. The plain solution receives the controlled
/// moments, the estimates in smooth bins, and the checks as metrics.
transform::Solution make_solution(Result&& result);

/// The plain solution with a note that no control variates are used.
/// @param reason reason in one clause, completes the note
transform::Solution make_plain_solution(transform::Solution&& plain, const std::string& reason);

}  // namespace fpkcheck::control_variates
