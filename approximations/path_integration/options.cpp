#include "approximations/path_integration/options.hpp"

#include <fmt/format.h>

namespace fpkcheck::path_integration {

using problem::DensityEquation;

const base::OptionsDescription<PathIntegrationOptions>& solver_option_descriptions() {
  static const auto description =
      base::OptionsDescription<PathIntegrationOptions>("path ")
          .add("equation", &PathIntegrationOptions::equation,
               {"E",
                "white: impulses as white noise of their intensity; kf: Poisson law of the "
                "impulses"})
          .with_choices({"white", "kf"})
          .add("intervals", &PathIntegrationOptions::intervals,
               {"N",
                "number of spline intervals in y' on the finest grid (default: the first with an "
                "error estimate of 1e-4, at most 128)"},
               base::closed_interval(24, 400))
          .add("accuracy", &PathIntegrationOptions::accuracy,
               {"L1", "largest L1 error estimate of p(y) and of p(y') with status ok"},
               base::positive_numbers());
  return description;
}

void validate(const PathIntegrationOptions& options) {
  solver_option_descriptions().validate(options);
}

transform::SolutionIdentity solution_identity(const PathIntegrationOptions& options) {
  return {.id = fmt::format("path-{}", problem::name(options.equation)),
          .method = "path",
          .equation = options.equation,
          .impact = problem::ImpactCondition::map,
          .role = transform::SolutionRole::equation};
}

std::optional<PathIntegrationOptions> options_of(std::string_view id) {
  for (const auto equation : {DensityEquation::white, DensityEquation::kf}) {
    if (id == solution_identity({.equation = equation}).id)
      return PathIntegrationOptions{.equation = equation};
  }
  return std::nullopt;
}

}  // namespace fpkcheck::path_integration
