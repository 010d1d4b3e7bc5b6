#include "workflows/check/compare_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/input_error.hpp"
#include "workflows/check/case_quantities.hpp"

namespace fpkcheck::check {
namespace {

template <class List>
void append_list(List& list, List more) {
  std::ranges::move(more, std::back_inserter(list));
}

CheckedQuantities case_quantities(const results::CaseResult& one, const results::CaseResult& other,
                                  bool is_baseline, const BaselineCheckTolerances& tolerances) {
  CheckedQuantities quantities;
  for (transform::Solution solution : one.solutions) {
    const auto* again = other.find(solution.id());
    if (is_baseline && again != nullptr) {
      solution.metrics =
          copy_metric_kinds_from_repeated_run(std::move(solution.metrics), again->metrics);
    }
    append_list(quantities, solution_quantities(solution, tolerances));
  }
  append_list(quantities, distance_quantities(one, other, tolerances));
  append_list(quantities, budget_quantities(one, other, tolerances));
  return quantities;
}

}  // namespace

std::vector<CheckedQuantityChange> BaselineCheckResult::quantities_beyond_tolerance() const {
  std::vector<CheckedQuantityChange> result;
  std::ranges::copy_if(changes, std::back_inserter(result),
                       &CheckedQuantityChange::exceeds_tolerance);
  return result;
}

bool BaselineCheckResult::agrees_with_baseline() const {
  return std::ranges::none_of(changes, &CheckedQuantityChange::exceeds_tolerance);
}

BaselineCheckResult compare_runs(const results::Run& baseline, const results::Run& now,
                                 const BaselineCheckTolerances& tolerances, bool with_marginals) {
  BaselineCheckResult result{tolerances, {}, 0, {}};
  for (const results::CaseResult& was : baseline.cases) {
    const auto is = std::ranges::find(now.cases, was.name(), &results::CaseResult::name);
    if (is == now.cases.end()) {
      throw InputError(fmt::format("case {} is missing in the new run", was.name()));
    }
    result.solutions += was.solutions.size();
    append_list(result.changes,
                compare_quantities(was.name(), case_quantities(was, *is, true, tolerances),
                                   case_quantities(*is, was, false, tolerances)));
    if (with_marginals) append_list(result.changes, marginal_changes(was, *is, tolerances));
  }
  return result;
}

std::vector<CheckedQuantityKindSummary> summarise_changes_by_kind(
    const BaselineCheckResult& check) {
  std::vector<CheckedQuantityKindSummary> kinds;
  for (const auto& entry : kQuantityKindNames) {
    CheckedQuantityKindSummary summary{entry.value};
    for (const auto& quantity_change : check.changes) {
      if (quantity_change.kind != entry.value) continue;
      ++summary.count;
      if (quantity_change.exceeds_tolerance()) {
        ++summary.moved;
      } else if (summary.largest == nullptr || quantity_change.change_divided_by_tolerance() >
                                                   summary.largest->change_divided_by_tolerance()) {
        summary.largest = &quantity_change;
      }
    }
    if (summary.count > 0) kinds.push_back(summary);
  }
  return kinds;
}

}  // namespace fpkcheck::check
