#include "compare/limiting_errors.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "compare/agreement.hpp"
#include "compare/model_chain.hpp"

namespace fpkcheck::compare {
namespace {

using transform::Solution;

// Returns the L1 error of the reference solution in a row of the error budget: the 99 % quantile of
// the sampling error of a simulation, the discretisation error of a Richardson limit, or 0 if the
// error is unknown.
double reference_error(const ErrorBudgetRow& row) {
  const ErrorBudgetPart& last = row.parts.back();
  return last.quantile_99.value_or(last.uncertainty.value_or(0));
}

struct ComparedSolutionsOfCase {
  std::span<const Solution> solutions;
  std::span<const SolutionPairDistances> pairs;
};

bool references_disagree(const ErrorBudgetRow& row, const ComparedSolutionsOfCase& compared) {
  const ErrorBudgetPart& last = row.parts.back();
  if (last.approximations != std::vector{ModelApproximation::sampling}) return false;
  const std::string from = last.from.substr(0, last.from.find(kGridLimitSuffix));
  const Solution* one = transform::find_solution(compared.solutions, from);
  const Solution* other = transform::find_solution(compared.solutions, last.to);
  return one != nullptr && other != nullptr && !solutions_agree(*one, *other, compared.pairs);
}

bool is_within_reference_error(const ClosureErrorBudget& budget,
                               const ComparedSolutionsOfCase& compared) {
  return std::ranges::all_of(budget.existing_budget_rows(), [&](const ErrorBudgetRow* row) {
    return !references_disagree(*row, compared) && row->total <= reference_error(*row);
  });
}

void add_closure_to_groups(const ClosureErrorBudget& budget,
                           const ComparedSolutionsOfCase& compared,
                           std::vector<ClosuresWithSameLimitingError>& groups) {
  std::map<std::string, double> parts;
  double sum = 0;
  for (const ErrorBudgetRow* row : budget.existing_budget_rows()) {
    for (const auto& part : row->parts) {
      parts[part.error_budget_part_name()] += part.l1;
      sum += part.l1;
    }
  }
  const auto largest =
      std::ranges::max_element(parts, {}, [](const auto& part) { return part.second; });
  const std::string limit = is_within_reference_error(budget, compared) ? "" : largest->first;
  auto group = std::ranges::find(groups, limit, &ClosuresWithSameLimitingError::part);
  if (group == groups.end()) group = groups.insert(group, {.part = limit, .closures = {}});
  group->closures.push_back(budget.solution);
  const double fraction = sum > 0 ? largest->second / sum : 0;
  group->least_fraction = std::min(group->least_fraction, fraction);
  group->greatest_fraction = std::max(group->greatest_fraction, fraction);
}

}  // namespace

LimitingErrorsOfClosures find_limiting_errors(std::span<const ErrorBudgetRow> budget,
                                              std::span<const Solution> solutions,
                                              std::span<const SolutionPairDistances> pairs) {
  const ComparedSolutionsOfCase compared{solutions, pairs};
  LimitingErrorsOfClosures errors;
  for (const auto& closure : group_budget_by_closure(budget, solutions))
    add_closure_to_groups(closure, compared, errors.groups);
  errors.has_reference_disagreement = std::ranges::any_of(
      budget, [&](const ErrorBudgetRow& row) { return references_disagree(row, compared); });
  return errors;
}

}  // namespace fpkcheck::compare
