#pragma once

#include <optional>
#include <string_view>

#include "base/options/option_description.hpp"
#include "problem/equation_and_impact_condition.hpp"
#include "transform/solution_identity.hpp"

/// Path integration (Wehner and Wolfer, Physical Review A 27, 2663 (1983); Naess and Johnsen,
/// Probabilistic Engineering Mechanics 8, 91 (1993)): the stationary density is the fixed point of
/// the transition over a short time.
namespace fpkcheck::path_integration {

struct PathIntegrationOptions {
  /// Equation: `white` replaces the impulses by white noise of their intensity, and `kf` has the
  /// Poisson law of the impulses.
  problem::DensityEquation equation = problem::DensityEquation::kf;
  /// Number of spline intervals along the velocity on the finest grid; by default the first number
  /// with which the error estimate is at most 1e-4, and at most 128.
  std::optional<int> intervals{};
  /// Largest L1 error of p(y) and of p(y') with which the caller accepts a solution as `ok`.
  double accuracy = 1e-2;
};

const base::OptionsDescription<PathIntegrationOptions>& solver_option_descriptions();
/// @throws InputError that states the option, its value and the allowed values
void validate(const PathIntegrationOptions& options);
transform::SolutionIdentity solution_identity(const PathIntegrationOptions& options);
/// Returns the options of the id "path-white" or "path-kf"; empty for other ids.
std::optional<PathIntegrationOptions> options_of(std::string_view id);

}  // namespace fpkcheck::path_integration
