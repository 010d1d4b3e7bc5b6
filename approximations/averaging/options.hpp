#pragma once

#include <optional>
#include <string_view>

#include "base/options/option_description.hpp"
#include "problem/equation_and_impact_condition.hpp"
#include "transform/solution_identity.hpp"

/// Stochastic averaging of the energy envelope (Stratonovich 1963, Khasminskii 1964, Zhu 1988): the
/// density depends only on the energy and on the well.
namespace fpkcheck::averaging {

struct AveragingOptions {
  /// Equation of the energy: `white` replaces the impulses by white noise of their intensity, and
  /// `kf` contains the jumps of the energy at impulses.
  problem::DensityEquation equation = problem::DensityEquation::kf;
  /// Largest L1 error of p(y) and of p(y') with which the caller accepts a solution as `ok`.
  double accuracy = 2e-2;
};

const base::OptionsDescription<AveragingOptions>& solver_option_descriptions();
/// @throws InputError that states the option, its value and the allowed values
void validate(const AveragingOptions& options);
transform::SolutionIdentity solution_identity(const AveragingOptions& options);
/// Returns the options of the id "averaging-white" or "averaging-kf"; empty for other ids.
std::optional<AveragingOptions> options_of(std::string_view id);

}  // namespace fpkcheck::averaging
