#include "approximations/cumulant/options.hpp"

#include <fmt/format.h>

#include "problem/impulse_law.hpp"

namespace fpkcheck::cumulant {
namespace {

using problem::ImpactCondition;

constexpr int kMaxOrder = problem::kMomentCount - 1;

}  // namespace

const base::OptionsDescription<CumulantOptions>& solver_option_descriptions() {
  static const auto description =
      base::OptionsDescription<CumulantOptions>("cumulant ")
          .add("order", &CumulantOptions::order,
               {"N", "closure order, 2, 4 or 6: the cumulants above this order are 0"},
               base::even_integers_between(2, kMaxOrder))
          .add("impact", &CumulantOptions::impact,
               {"I",
                "change of y'^q by an impact at speed u: map: (r^q-1) u^q; delta: -q (1-r) u^q, "
                "to first order in 1-r"})
          .with_choices({"map", "delta"})
          .add("accuracy", &CumulantOptions::accuracy,
               {"L1", "largest L1 error estimate of p(y) and of p(y') with status ok"},
               base::positive_numbers().with_reason_in_message("no cumulant closure is exact"));
  return description;
}

void validate(const CumulantOptions& options) { solver_option_descriptions().validate(options); }

transform::SolutionIdentity solution_identity(const CumulantOptions& options) {
  const bool exact_impact = options.impact == ImpactCondition::map;
  return {.id = fmt::format("cumulant{}-n{}", exact_impact ? "" : "-delta", options.order),
          .method = "cumulant",
          .formulation = exact_impact ? "cumulant" : "cumulant-delta",
          .order = options.order,
          .equation = problem::DensityEquation::kf,
          .impact = options.impact};
}

std::optional<CumulantOptions> options_of(std::string_view id) {
  for (int order = 2; order <= kMaxOrder; order += 2) {
    for (const auto impact : {ImpactCondition::map, ImpactCondition::delta}) {
      const CumulantOptions options{.order = order, .impact = impact};
      if (id == solution_identity(options).id) return options;
    }
  }
  return std::nullopt;
}

}  // namespace fpkcheck::cumulant
