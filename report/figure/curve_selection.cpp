#include "report/figure/curve_selection.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "report/case_solutions.hpp"

namespace fpkcheck::report {
namespace {

using transform::SolutionIdentity;
using transform::SolutionRole;

constexpr const char* kAllCurves = "all";

bool matches_request(const std::string& requested, const SolutionIdentity& identity) {
  return requested == kAllCurves || requested == identity.id || requested == identity.family ||
         requested == identity.method;
}

bool has_curve(const results::CaseResult& case_result, const transform::Solution& solution) {
  return std::ranges::any_of(transform::kVariables, [&](transform::StateVariable variable) {
    return case_result.marginal_curve(solution.id(), variable) != nullptr;
  });
}

// Returns the solutions of a case that have a curve, by decreasing priority in the default
// selection of curves.
std::vector<const transform::Solution*> solutions_by_priority(
    const results::CaseResult& case_result) {
  std::vector<const transform::Solution*> order;
  const auto add = [&](const transform::Solution& solution) {
    const bool is_new = std::ranges::count(order, &solution) == 0;
    if (is_new && has_curve(case_result, solution)) order.push_back(&solution);
  };
  for (const auto* solution : solutions_of_full_problem(case_result)) add(*solution);
  std::vector<const transform::Solution*> closures;
  for (const auto* closure : case_result.assessment.closures_ranked_by_distance())
    closures.push_back(case_result.find(closure->id));
  std::set<std::string> formulations;
  for (const auto* closure : closures) {
    if (formulations.insert(closure->identity.formulation).second) add(*closure);
  }
  for (auto solution = case_result.solutions.rbegin(); solution != case_result.solutions.rend();
       ++solution) {
    if (solution->identity.role != SolutionRole::closure && solution->has_status_ok())
      add(*solution);
  }
  for (const auto* closure : closures) add(*closure);
  for (auto solution = case_result.solutions.rbegin(); solution != case_result.solutions.rend();
       ++solution) {
    add(*solution);
  }
  return order;
}

}  // namespace

std::set<std::string> select_solutions_to_draw(const results::CaseResult& case_result,
                                               const std::vector<std::string>& requested) {
  std::set<std::string> ids;
  for (const auto& solution : case_result.solutions) {
    const bool is_requested = requested.empty()
                                  ? transform::is_external(solution.identity)
                                  : std::ranges::any_of(requested, [&](const std::string& item) {
                                      return matches_request(item, solution.identity);
                                    });
    if (is_requested && has_curve(case_result, solution)) ids.insert(solution.id());
  }
  if (!requested.empty()) return ids;
  for (const auto* solution : solutions_by_priority(case_result)) {
    if (ids.size() < kMaxDefaultCurves) ids.insert(solution->id());
  }
  return ids;
}

std::set<std::string> initially_visible_solutions(const results::CaseResult& case_result) {
  std::set<std::string> ids, families;
  for (const auto* closure : case_result.assessment.closures_ranked_by_distance()) {
    const auto& family = case_result.find(closure->id)->identity.family;
    if (families.insert(family).second) ids.insert(closure->id);
  }
  for (const auto* solution : solutions_of_full_problem(case_result)) ids.insert(solution->id());
  for (const auto& solution : case_result.solutions) {
    if (transform::is_external(solution.identity)) ids.insert(solution.id());
  }
  if (ids.size() < 2) {
    for (const auto& solution : case_result.solutions) ids.insert(solution.id());
  }
  return ids;
}

void require_requested_curves_exist(const std::vector<std::string>& requested,
                                    std::span<const SolutionIdentity> available) {
  for (const auto& item : requested) {
    const bool is_available =
        item == kAllCurves || std::ranges::any_of(available, [&](const SolutionIdentity& identity) {
          return matches_request(item, identity);
        });
    if (is_available) continue;
    std::vector<std::string> ids;
    for (const auto& identity : available) {
      if (std::ranges::count(ids, identity.id) == 0) ids.push_back(identity.id);
    }
    throw InputError(fmt::format("--curves: {} matches no solution; use all, a family or one of {}",
                                 base::in_quotes(item), fmt::join(ids, ", ")));
  }
}

}  // namespace fpkcheck::report
