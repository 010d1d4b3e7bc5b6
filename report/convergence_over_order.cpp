#include "report/convergence_over_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/assessment.hpp"
#include "report/references.hpp"

namespace fpkcheck::report {
namespace {

using transform::Solution;

int order_of(const Solution* solution) { return *solution->identity.order; }

std::vector<UncertaintyLine> uncertainty_lines(const ConvergenceOverOrder& distances) {
  std::vector<UncertaintyLine> all;
  for (const Solution* other : references(*distances.case_result)) {
    const double l1 = distances.l1(*other);
    if (l1 > 0)
      all.push_back(
          {fmt::format("distance of {} to {}", other->id(), distances.reference->id()), l1, "(2,4)"});
  }
  const double own = compare::l1_error_estimate(*distances.reference, distances.variable);
  if (std::isfinite(own) && own > 0) {
    all.push_back({"error estimate of " + distances.reference->id(), own, "(8,4)"});
  }
  return all;
}

}  // namespace

double ConvergenceOverOrder::l1(const Solution& solution) const {
  return case_result->l1(solution.id(), reference->id(), variable).value_or(0);
}

std::pair<int, int> ConvergenceOverOrder::order_range() const {
  int first = order_of(families.front().solutions.front()), last = first;
  const auto include = [&](const Solution* solution) {
    first = std::min(first, order_of(solution));
    last = std::max(last, order_of(solution));
  };
  for (const SolutionFamily& family : families) std::ranges::for_each(family.solutions, include);
  for (const Solution* external_density : external_densities) {
    if (external_density->identity.order) include(external_density);
  }
  return {first, last};
}

std::optional<ConvergenceOverOrder> convergence_over_order(const results::CaseResult& case_result,
                                                           transform::Variable variable) {
  const Solution* reference = case_result.reference();
  if (reference == nullptr) return std::nullopt;
  ConvergenceOverOrder distances{.case_result = &case_result,
                                 .reference = reference,
                                 .variable = variable,
                                 .families = {},
                                 .external_densities = {},
                                 .uncertainty_lines = {}};
  std::vector<const Solution*> by_order;
  for (const auto& solution : case_result.solutions) {
    if (!(distances.l1(solution) > 0)) continue;
    if (transform::is_distinguished_by_order(solution.identity)) {
      by_order.push_back(&solution);
    } else if (transform::is_external(solution.identity)) {
      distances.external_densities.push_back(&solution);
    }
  }
  distances.families = group_by_family(by_order);
  const bool any = std::ranges::any_of(
      distances.families, [](const SolutionFamily& family) { return family.solutions.size() > 1; });
  if (!any) return std::nullopt;
  for (SolutionFamily& family : distances.families)
    std::ranges::stable_sort(family.solutions, {}, order_of);
  distances.uncertainty_lines = uncertainty_lines(distances);
  return distances;
}

}  // namespace fpkcheck::report
