#include "compare/budget/limits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <vector>

#include "compare/budget/view.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kBelowTheReference = "";

/// Closures that one part limits.
struct Group {
  std::string part;
  std::vector<const ClosureBudget*> closures;
  double least_share = 1, greatest_share = 0;  ///< of the part in the sum of all parts
};

// What the reference of a row is known to: the simulation to what 99 runs of 100 stay below, the
// limit of the finite differences to their discretisation error; 0 where neither is known.
double reference_error(const Json& row) {
  const Json& last = row.at("parts").back();
  return number(last, "in_99").value_or(number(last, "uncertainty").value_or(0));
}

// Finite differences and the simulation are further apart than chance explains: then the last part
// is more than sampling.
bool references_disagree(const Json& row) {
  const Json& last = row.at("parts").back();
  const auto in_99 = number(last, "in_99");
  return last.at("name") == "sampling" && in_99 && number(last, "l1").value_or(0) > *in_99;
}

bool references_disagree(const std::vector<ClosureBudget>& budgets) {
  return std::ranges::any_of(budgets, [](const ClosureBudget& budget) {
    return std::ranges::any_of(rows_of(budget),
                               [](const Json* row) { return references_disagree(*row); });
  });
}

bool nearer_than_the_reference_is_known(const ClosureBudget& budget) {
  return std::ranges::all_of(rows_of(budget), [](const Json* row) {
    return !references_disagree(*row) && number(*row, "total").value_or(1) <= reference_error(*row);
  });
}

void add(const ClosureBudget& budget, std::vector<Group>& groups) {
  std::map<std::string, double> parts;
  double sum = 0;
  for (const Json* row : rows_of(budget)) {
    for (const auto& part : row->at("parts")) {
      const double l1 = number(part, "l1").value_or(0);
      parts[part.at("name").get<std::string>()] += l1;
      sum += l1;
    }
  }
  const auto largest =
      std::ranges::max_element(parts, {}, [](const auto& part) { return part.second; });
  const std::string name =
      nearer_than_the_reference_is_known(budget) ? kBelowTheReference : largest->first;
  auto group = std::ranges::find(groups, name, &Group::part);
  if (group == groups.end()) group = groups.insert(group, {.part = name, .closures = {}});
  group->closures.push_back(&budget);
  const double share = sum > 0 ? largest->second / sum : 0;
  group->least_share = std::min(group->least_share, share);
  group->greatest_share = std::max(group->greatest_share, share);
}

// "epc-gaussian-n2, -n4 (inadmissible) and -n6"
std::string list(const std::vector<const ClosureBudget*>& closures) {
  std::vector<std::string> names;
  std::string stem_before;
  for (const auto* closure : closures) {
    const auto mark = closure->solution.rfind("-n");
    const std::string stem = closure->solution.substr(0, mark);
    const bool again = !names.empty() && stem == stem_before && mark != std::string::npos;
    stem_before = stem;
    names.push_back(again ? closure->solution.substr(mark) : closure->solution);
    if (closure->status != "ok") names.back() += fmt::format(" ({})", closure->status);
  }
  if (names.size() == 1) return names.front();
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("{} and {}", fmt::join(names, ", "), last);
}

std::string subject(const std::string& part) {
  if (part == "closure") return "the closure itself";
  if (part == "impact") return "the impact to first order in 1-r";
  if (part == "truncation") return "the cut of the Kramers-Moyal series";
  if (part == "white noise") return "white noise in place of impulses";
  if (part == "discretisation") return "the discretisation of the reference";
  if (part == "sampling") return "the sampling of the reference";
  return part;  // several together
}

std::string shares(const Group& group) {
  const auto percent = [](double share) { return fmt::format("{:.0f}", 100 * share); };
  const auto least = percent(group.least_share), greatest = percent(group.greatest_share);
  return least == greatest ? fmt::format("{} %", least)
                           : fmt::format("{} to {} %", least, greatest);
}

// The first percentage says of what.
std::string text_of(const Group& group, bool& explained) {
  if (group.part != kBelowTheReference) {
    const char* of_what = explained ? "" : " of the sum of the parts";
    explained = true;
    return fmt::format("{} in {} ({}{})", subject(group.part), list(group.closures), shares(group),
                       of_what);
  }
  const bool simulated = rows_of(*group.closures.front()).front()->at("reference") == "mcs";
  return fmt::format("the reference in {}, which {} within its {} error in L1",
                     list(group.closures), group.closures.size() == 1 ? "lies" : "lie",
                     simulated ? "sampling" : "discretisation");
}

}  // namespace

std::string limits(const Json& summary_case) {
  const auto budgets = closure_budgets(summary_case);
  if (budgets.empty()) return "";
  std::vector<Group> groups;
  for (const auto& budget : budgets) add(budget, groups);
  std::vector<std::string> parts;
  bool explained = false;
  for (const auto& group : groups) parts.push_back(text_of(group, explained));
  const std::string text = fmt::format("What limits each closure: {}.", fmt::join(parts, "; "));
  if (!references_disagree(budgets)) return text;
  return text +
         " The part called sampling is more than that here: finite differences and the simulation "
         "are further apart than 99 of 100 simulations would be by chance.";
}

}  // namespace fpkcheck::compare
