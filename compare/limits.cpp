#include "compare/limits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <vector>

#include "compare/agreement.hpp"
#include "compare/chain.hpp"

namespace fpkcheck::compare {
namespace {

using transform::Solution;
using transform::Status;

constexpr const char* kBelowTheEnd = "";

/// Closures with the same limiting part.
struct Group {
  std::string part;
  std::vector<const ClosureBudget*> closures;
  double least_share = 1, greatest_share = 0;  ///< fraction of the part in the sum of all parts
};

// Error of the reference of a row: the 99 % quantile of the sampling error of a simulation, the
// discretisation error of a limit of finite volumes, 0 if unknown.
double error_of_the_end(const BudgetRow& row) {
  const BudgetPart& last = row.parts.back();
  return last.in_99.value_or(last.uncertainty.value_or(0));
}

/// The compared solutions and their distances.
struct Known {
  std::span<const Solution> solutions;
  std::span<const PairDistances> pairs;
};

// True if finite volumes and the simulation disagree: the last part then exceeds the sampling
// error.
bool references_disagree(const BudgetRow& row, const Known& known) {
  const BudgetPart& last = row.parts.back();
  if (last.links != std::vector{Link::sampling}) return false;
  const std::string from = last.from.substr(0, last.from.find(kLimitOfGrids));
  const Solution* one = transform::find_solution(known.solutions, from);
  const Solution* other = transform::find_solution(known.solutions, last.to);
  return one != nullptr && other != nullptr && !agree(*one, *other, known.pairs);
}

bool nearer_than_the_end_is_known(const ClosureBudget& budget, const Known& known) {
  return std::ranges::all_of(budget.rows(), [&](const BudgetRow* row) {
    return !references_disagree(*row, known) && row->total <= error_of_the_end(*row);
  });
}

void add(const ClosureBudget& budget, const Known& known, std::vector<Group>& groups) {
  std::map<std::string, double> parts;
  double sum = 0;
  for (const BudgetRow* row : budget.rows()) {
    for (const auto& part : row->parts) {
      parts[part.name()] += part.l1;
      sum += part.l1;
    }
  }
  const auto largest =
      std::ranges::max_element(parts, {}, [](const auto& part) { return part.second; });
  const std::string limit =
      nearer_than_the_end_is_known(budget, known) ? kBelowTheEnd : largest->first;
  auto group = std::ranges::find(groups, limit, &Group::part);
  if (group == groups.end()) group = groups.insert(group, {.part = limit, .closures = {}});
  group->closures.push_back(&budget);
  const double share = sum > 0 ? largest->second / sum : 0;
  group->least_share = std::min(group->least_share, share);
  group->greatest_share = std::max(group->greatest_share, share);
}

// "epc-gaussian-n2, -n4 (inadmissible) and -n6"
std::string list(const std::vector<const ClosureBudget*>& closures) {
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

std::string subject(const std::string& part) {
  const auto links = links_named(part);
  return links.size() == 1 ? std::string(base::meaning_of(links.front())) : part;
}

std::string shares(const Group& group) {
  const auto percent = [](double share) { return fmt::format("{:.0f}", 100 * share); };
  const auto least = percent(group.least_share), greatest = percent(group.greatest_share);
  return least == greatest ? fmt::format("{} %", least)
                           : fmt::format("{} to {} %", least, greatest);
}

// Text of a group. Only the first percentage of the sentence is explained.
std::string text_of(const Group& group, bool& explained) {
  if (group.part != kBelowTheEnd) {
    const char* of_what = explained ? "" : " of the sum of the parts";
    explained = true;
    return fmt::format("{} in {} ({}{})", subject(group.part), list(group.closures), shares(group),
                       of_what);
  }
  const BudgetRow& row = *group.closures.front()->rows().front();
  const bool by_chance = row.parts.back().expected.has_value();
  return fmt::format("none above the {} error of {} (L1) in {}",
                     by_chance ? "sampling" : "discretisation", row.reference,
                     list(group.closures));
}

}  // namespace

std::string limits(std::span<const BudgetRow> budget, std::span<const Solution> solutions,
                   std::span<const PairDistances> pairs) {
  const Known known{solutions, pairs};
  const auto budgets = closure_budgets(budget, solutions);
  if (budgets.empty()) return "";
  std::vector<Group> groups;
  for (const auto& closure : budgets) add(closure, known, groups);
  std::vector<std::string> parts;
  bool explained = false;
  for (const auto& group : groups) parts.push_back(text_of(group, explained));
  const std::string text =
      fmt::format("Limiting error of each closure: {}.", fmt::join(parts, "; "));
  const bool disagree = std::ranges::any_of(
      budget, [&](const BudgetRow& row) { return references_disagree(row, known); });
  if (!disagree) return text;
  return text +
         " The part `sampling` exceeds the sampling error: finite volumes and the simulation "
         "differ by more than their errors explain.";
}

}  // namespace fpkcheck::compare
