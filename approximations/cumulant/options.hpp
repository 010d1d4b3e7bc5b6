#pragma once

#include <optional>
#include <string_view>

#include "base/options/option_description.hpp"
#include "problem/equation_and_impact_condition.hpp"
#include "transform/solution_identity.hpp"

/// Cumulant neglect (Stratonovich 1963; Wu and Lin 1984; Ibrahim, Soundararajan and Heo 1985):
/// moment equations up to the order n, closed by setting the cumulants above the order n to 0, with
/// the density of a Gram-Charlier series.
namespace fpkcheck::cumulant {

struct CumulantOptions {
  int order = 4;  ///< closure order n: 2, 4 or 6
  /// Impact condition at a wall: `map` or, to first order in 1 - r, `delta`.
  problem::ImpactCondition impact = problem::ImpactCondition::map;
  /// Largest L1 error of p(y) and of p(y') with which the caller accepts a solution as `ok`.
  double accuracy = 2e-2;
};

const base::OptionsDescription<CumulantOptions>& solver_option_descriptions();
/// @throws InputError that states the option, its value and the allowed values
void validate(const CumulantOptions& options);
transform::SolutionIdentity solution_identity(const CumulantOptions& options);
/// Returns the options of an id such as "cumulant-n4" or "cumulant-delta-n4"; empty for other ids.
std::optional<CumulantOptions> options_of(std::string_view id);

}  // namespace fpkcheck::cumulant
