#pragma once

#include <optional>
#include <string_view>

#include "base/options/option_description.hpp"
#include "problem/equation_and_impact_condition.hpp"
#include "transform/solution_identity.hpp"

/// Statistical linearisation (Booton 1954, Kazakov 1956, Caughey 1963): a Gaussian density whose
/// mean and variances satisfy the moment equations of the nonlinear oscillator.
namespace fpkcheck::linearisation {

struct LinearisationOptions {
  /// Impact condition of the energy loss at a wall: `map` or, to first order in 1 - r, `delta`.
  problem::ImpactCondition impact = problem::ImpactCondition::map;
  /// Largest L1 error of p(y) and of p(y') with which the caller accepts a solution as `ok`.
  double accuracy = 2e-2;
};

const base::OptionsDescription<LinearisationOptions>& solver_option_descriptions();
/// @throws InputError that states the option, its value and the allowed values
void validate(const LinearisationOptions& options);
transform::SolutionIdentity solution_identity(const LinearisationOptions& options);
/// Returns the options of the id "linearisation" or "linearisation-delta"; empty for other ids.
std::optional<LinearisationOptions> options_of(std::string_view id);

}  // namespace fpkcheck::linearisation
