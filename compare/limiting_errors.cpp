#include "compare/limiting_errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <vector>

#include "compare/agreement.hpp"
#include "compare/model_chain.hpp"

namespace fpkcheck::compare {
namespace {

using transform::Solution;
using transform::Status;

constexpr const char* kWithinReferenceError = "";

/// Closures with the same limiting error: the same part of their budgets is the largest.
struct ClosureGroup {
  std::string part;
  std::vector<const ClosureErrorBudget*> closures;
  /// Smallest and largest fraction of this part in the sum of all parts, over the closures.
  double least_fraction = 1, greatest_fraction = 0;
};

// L1 error of the reference of a budget: the 99 % quantile of the sampling error if the reference
// is a simulation, the discretisation error if the reference is a Richardson limit, 0 if unknown.
double reference_error(const ErrorBudgetRow& row) {
  const ErrorBudgetPart& last = row.parts.back();
  return last.quantile_99.value_or(last.uncertainty.value_or(0));
}

/// The compared solutions and their distances.
struct ComparedSolutions {
  std::span<const Solution> solutions;
  std::span<const PairDistances> pairs;
};

// Whether the finite-volume solution and the simulation, the models of the part `sampling`,
// disagree.
bool has_reference_disagreement(const ErrorBudgetRow& row, const ComparedSolutions& compared) {
  const ErrorBudgetPart& last = row.parts.back();
  if (last.approximations != std::vector{Approximation::sampling}) return false;
  const std::string from = last.from.substr(0, last.from.find(kGridLimitSuffix));
  const Solution* one = transform::find_solution(compared.solutions, from);
  const Solution* other = transform::find_solution(compared.solutions, last.to);
  return one != nullptr && other != nullptr && !has_agreement(*one, *other, compared.pairs);
}

bool is_within_reference_error(const ClosureErrorBudget& budget,
                               const ComparedSolutions& compared) {
  return std::ranges::all_of(budget.rows(), [&](const ErrorBudgetRow* row) {
    return !has_reference_disagreement(*row, compared) && row->total <= reference_error(*row);
  });
}

void add_to_groups(const ClosureErrorBudget& budget, const ComparedSolutions& compared,
                   std::vector<ClosureGroup>& groups) {
  std::map<std::string, double> parts;
  double sum = 0;
  for (const ErrorBudgetRow* row : budget.rows()) {
    for (const auto& part : row->parts) {
      parts[part.name()] += part.l1;
      sum += part.l1;
    }
  }
  const auto largest =
      std::ranges::max_element(parts, {}, [](const auto& part) { return part.second; });
  const std::string limit =
      is_within_reference_error(budget, compared) ? kWithinReferenceError : largest->first;
  auto group = std::ranges::find(groups, limit, &ClosureGroup::part);
  if (group == groups.end()) group = groups.insert(group, {.part = limit, .closures = {}});
  group->closures.push_back(&budget);
  const double fraction = sum > 0 ? largest->second / sum : 0;
  group->least_fraction = std::min(group->least_fraction, fraction);
  group->greatest_fraction = std::max(group->greatest_fraction, fraction);
}

// The ids of closures as text: "epc-gaussian-n2, -n4 (inadmissible) and -n6".
std::string closure_id_list(const std::vector<const ClosureErrorBudget*>& closures) {
  std::vector<std::string> ids;
  std::string stem_before;
  for (const auto* closure : closures) {
    const auto mark = closure->solution.rfind("-n");
    const std::string stem = closure->solution.substr(0, mark);
    const bool again = !ids.empty() && stem == stem_before && mark != std::string::npos;
    stem_before = stem;
    ids.push_back(again ? closure->solution.substr(mark) : closure->solution);
    if (closure->status != Status::ok) ids.back() += fmt::format(" ({})", name(closure->status));
  }
  if (ids.size() == 1) return ids.front();
  const std::string last = ids.back();
  ids.pop_back();
  return fmt::format("{} and {}", fmt::join(ids, ", "), last);
}

std::string part_meaning(const std::string& part) {
  const auto approximations = parse_approximations(part);
  return approximations.size() == 1 ? std::string(base::meaning_of(approximations.front())) : part;
}

std::string fractions_text(const ClosureGroup& group) {
  const auto percent = [](double fraction) { return fmt::format("{:.0f}", 100 * fraction); };
  const auto least = percent(group.least_fraction), greatest = percent(group.greatest_fraction);
  return least == greatest ? fmt::format("{} %", least)
                           : fmt::format("{} to {} %", least, greatest);
}

// Text of a group of closures. Only the first percentage of the sentence has the explanation "of
// the sum of the parts".
std::string closure_group_text(const ClosureGroup& group, bool& explained) {
  if (group.part != kWithinReferenceError) {
    const char* of_what = explained ? "" : " of the sum of the parts";
    explained = true;
    return fmt::format("{} in {} ({}{})", part_meaning(group.part), closure_id_list(group.closures),
                       fractions_text(group), of_what);
  }
  const ErrorBudgetRow& row = *group.closures.front()->rows().front();
  const bool by_chance = row.parts.back().expected.has_value();
  return fmt::format("none above the {} error of {} (L1) in {}",
                     by_chance ? "sampling" : "discretisation", row.reference,
                     closure_id_list(group.closures));
}

}  // namespace

std::string limiting_errors_text(std::span<const ErrorBudgetRow> budget,
                                 std::span<const Solution> solutions,
                                 std::span<const PairDistances> pairs) {
  const ComparedSolutions compared{solutions, pairs};
  const auto budgets = closure_error_budgets(budget, solutions);
  if (budgets.empty()) return "";
  std::vector<ClosureGroup> groups;
  for (const auto& closure : budgets) add_to_groups(closure, compared, groups);
  std::vector<std::string> parts;
  bool explained = false;
  for (const auto& group : groups) parts.push_back(closure_group_text(group, explained));
  const std::string text =
      fmt::format("Limiting error of each closure: {}.", fmt::join(parts, "; "));
  const bool disagree = std::ranges::any_of(
      budget, [&](const ErrorBudgetRow& row) { return has_reference_disagreement(row, compared); });
  if (!disagree) return text;
  return text +
         " The part `sampling` exceeds the sampling error: finite volumes and the simulation "
         "differ by more than their errors explain.";
}

}  // namespace fpkcheck::compare
