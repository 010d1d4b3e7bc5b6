#include "approximations/averaging/options.hpp"

#include <fmt/format.h>

namespace fpkcheck::averaging {

using problem::DensityEquation;

const base::OptionsDescription<AveragingOptions>& solver_option_descriptions() {
  static const auto description =
      base::OptionsDescription<AveragingOptions>("averaging ")
          .add("equation", &AveragingOptions::equation,
               {"E",
                "white: impulses as white noise of their intensity; kf: jumps of the energy at "
                "impulses"})
          .with_choices({"white", "kf"})
          .add("accuracy", &AveragingOptions::accuracy,
               {"L1", "largest L1 error estimate of p(y) and of p(y') with status ok"},
               base::positive_numbers().with_reason_in_message("averaging is never exact"));
  return description;
}

void validate(const AveragingOptions& options) { solver_option_descriptions().validate(options); }

transform::SolutionIdentity solution_identity(const AveragingOptions& options) {
  return {.id = fmt::format("averaging-{}", problem::name(options.equation)),
          .method = "averaging",
          .equation = options.equation,
          .impact = problem::ImpactCondition::map};
}

std::optional<AveragingOptions> options_of(std::string_view id) {
  for (const auto equation : {DensityEquation::white, DensityEquation::kf}) {
    if (id == solution_identity({.equation = equation}).id)
      return AveragingOptions{.equation = equation};
  }
  return std::nullopt;
}

}  // namespace fpkcheck::averaging
