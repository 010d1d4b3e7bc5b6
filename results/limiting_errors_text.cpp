#include "results/run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace fpkcheck::results {
namespace {

using compare::ClosuresWithSameLimitingError;

// Returns the ids of a group of closures as text: "epc-gaussian-n2, -n4 (inadmissible) and -n6".
std::string closure_id_list(const CaseResult& case_result,
                            const ClosuresWithSameLimitingError& group) {
  std::vector<std::string> ids;
  std::string stem_before;
  for (const auto& id : group.closures) {
    const auto mark = id.rfind("-n");
    const std::string stem = id.substr(0, mark);
    const bool again = !ids.empty() && stem == stem_before && mark != std::string::npos;
    stem_before = stem;
    ids.push_back(again ? id.substr(mark) : id);
    const auto* closure = case_result.find(id);
    if (closure != nullptr && !closure->has_status_ok())
      ids.back() += fmt::format(" ({})", name(closure->status));
  }
  if (ids.size() == 1) return ids.front();
  const std::string last = ids.back();
  ids.pop_back();
  return fmt::format("{} and {}", fmt::join(ids, ", "), last);
}

std::string budget_part_meaning(const std::string& part) {
  const auto approximations = compare::parse_approximations(part);
  return approximations.size() == 1 ? std::string(base::meaning_of(approximations.front())) : part;
}

std::string error_fractions_text(const ClosuresWithSameLimitingError& group) {
  const auto percent = [](double fraction) { return fmt::format("{:.0f}", 100 * fraction); };
  const auto least = percent(group.least_fraction), greatest = percent(group.greatest_fraction);
  return least == greatest ? fmt::format("{} %", least)
                           : fmt::format("{} to {} %", least, greatest);
}

// Returns the text of a group of closures with the same limiting error. Only the first percentage
// in the text on limiting errors has the explanation "of the sum of the parts".
std::string closure_group_text(const CaseResult& case_result,
                               const ClosuresWithSameLimitingError& group, bool& explained) {
  const std::string closures = closure_id_list(case_result, group);
  if (!group.part.empty()) {
    const char* of_what = explained ? "" : " of the sum of the parts";
    explained = true;
    return fmt::format("{} in {} ({}{})", budget_part_meaning(group.part), closures,
                       error_fractions_text(group), of_what);
  }
  const auto row = std::ranges::find(case_result.budget, group.closures.front(),
                                     &compare::ErrorBudgetRow::solution);
  const bool by_chance = row->parts.back().expected.has_value();
  return fmt::format("none above the {} error of {} (L1) in {}",
                     by_chance ? "sampling" : "discretisation", row->reference, closures);
}

}  // namespace

std::string limiting_errors_text(const CaseResult& case_result) {
  const auto& errors = case_result.assessment.limiting_errors;
  if (errors.groups.empty()) return "";
  std::vector<std::string> parts;
  bool explained = false;
  for (const auto& group : errors.groups)
    parts.push_back(closure_group_text(case_result, group, explained));
  return fmt::format(
      "Limiting error of each closure: {}.{}", fmt::join(parts, "; "),
      errors.has_reference_disagreement
          ? " Finite volumes and the simulation differ by more than their errors explain, which "
            "increases the part `sampling`."
          : "");
}

}  // namespace fpkcheck::results
