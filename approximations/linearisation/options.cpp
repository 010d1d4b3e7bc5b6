#include "approximations/linearisation/options.hpp"

namespace fpkcheck::linearisation {

using problem::ImpactCondition;

const base::OptionsDescription<LinearisationOptions>& solver_option_descriptions() {
  static const auto description =
      base::OptionsDescription<LinearisationOptions>("linearisation ")
          .add("impact", &LinearisationOptions::impact,
               {"I",
                "energy loss of an impact at speed u: map: (1-r^2) u^2/2; delta: (1-r) u^2, to "
                "first order in 1-r"})
          .with_choices({"map", "delta"})
          .add("accuracy", &LinearisationOptions::accuracy,
               {"L1", "largest L1 error estimate of p(y) and of p(y') with status ok"},
               base::positive_numbers().with_reason_in_message("no linearisation is exact"));
  return description;
}

void validate(const LinearisationOptions& options) {
  solver_option_descriptions().validate(options);
}

transform::SolutionIdentity solution_identity(const LinearisationOptions& options) {
  const bool exact_impact = options.impact == ImpactCondition::map;
  return {.id = exact_impact ? "linearisation" : "linearisation-delta",
          .method = "linearisation",
          .equation = problem::DensityEquation::white,
          .impact = options.impact};
}

std::optional<LinearisationOptions> options_of(std::string_view id) {
  for (const auto impact : {ImpactCondition::map, ImpactCondition::delta}) {
    if (id == solution_identity({.impact = impact}).id)
      return LinearisationOptions{.impact = impact};
  }
  return std::nullopt;
}

}  // namespace fpkcheck::linearisation
