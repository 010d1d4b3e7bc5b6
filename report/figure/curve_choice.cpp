#include "report/figure/curve_choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/input_error.hpp"
#include "base/text/shown.hpp"
#include "compare/reference.hpp"
#include "report/references.hpp"

namespace fpkcheck::report {
namespace {

using transform::Identity;
using transform::Role;

constexpr const char* kAll = "all";

bool means(const std::string& wanted, const Identity& identity) {
  return wanted == kAll || wanted == identity.id || wanted == identity.family ||
         wanted == identity.method;
}

bool has_curve(const results::Case& one, const transform::Solution& solution) {
  return std::ranges::any_of(transform::kVariables, [&](transform::Variable variable) {
    return one.curve(solution.id(), variable) != nullptr;
  });
}

// All solutions with a curve, by decreasing priority.
std::vector<const transform::Solution*> by_interest(const results::Case& one) {
  std::vector<const transform::Solution*> order;
  const auto add = [&](const transform::Solution& solution) {
    const bool is_new = std::ranges::count(order, &solution) == 0;
    if (is_new && has_curve(one, solution)) order.push_back(&solution);
  };
  for (const auto* solution : references(one)) add(*solution);
  const auto closures = compare::closures_by_distance(one.solutions, one.pairs);
  std::set<std::string> formulations;
  for (const auto& rank : closures) {
    if (formulations.insert(rank.solution->identity.formulation).second) add(*rank.solution);
  }
  for (auto solution = one.solutions.rbegin(); solution != one.solutions.rend(); ++solution) {
    if (solution->identity.role != Role::closure && solution->is_ok()) add(*solution);
  }
  for (const auto& rank : closures) add(*rank.solution);
  for (auto solution = one.solutions.rbegin(); solution != one.solutions.rend(); ++solution) {
    add(*solution);
  }
  return order;
}

}  // namespace

std::set<std::string> chosen_curves(const results::Case& one,
                                    const std::vector<std::string>& wanted) {
  std::set<std::string> ids;
  for (const auto& solution : one.solutions) {
    const bool is_wanted = wanted.empty()
                               ? transform::is_guest(solution.identity)
                               : std::ranges::any_of(wanted, [&](const std::string& item) {
                                   return means(item, solution.identity);
                                 });
    if (is_wanted && has_curve(one, solution)) ids.insert(solution.id());
  }
  if (!wanted.empty()) return ids;
  for (const auto* solution : by_interest(one)) {
    if (ids.size() < kMostCurves) ids.insert(solution->id());
  }
  return ids;
}

void require_curves(const std::vector<std::string>& wanted, std::span<const Identity> there) {
  for (const auto& item : wanted) {
    const bool known = item == kAll || std::ranges::any_of(there, [&](const Identity& identity) {
                         return means(item, identity);
                       });
    if (known) continue;
    std::vector<std::string> ids;
    for (const auto& identity : there) {
      if (std::ranges::count(ids, identity.id) == 0) ids.push_back(identity.id);
    }
    throw InputError(fmt::format("--curves: {} matches no solution; use all, a family or one of {}",
                                 base::in_quotes(item), fmt::join(ids, ", ")));
  }
}

}  // namespace fpkcheck::report
