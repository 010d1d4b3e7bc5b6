#include "compare/budget/view.hpp"

#include <algorithm>

#include "compare/summary_view.hpp"

namespace fpkcheck::compare {

using Json = nlohmann::ordered_json;

std::vector<ClosureBudget> closure_budgets(const Json& summary_case) {
  std::vector<ClosureBudget> budgets;
  for (const auto& row : summary_case.at("budget")) {
    const auto id = row.at("solution").get<std::string>();
    auto found = std::ranges::find(budgets, id, &ClosureBudget::solution);
    if (found == budgets.end()) {
      const Json* solution = find_solution(summary_case, id);
      const auto status =
          solution != nullptr ? solution->at("status").get<std::string>() : std::string("ok");
      found = budgets.insert(found, {id, status});
    }
    (row.at("variable") == "y" ? found->y : found->ydot) = &row;
  }
  return budgets;
}

std::vector<const Json*> rows_of(const ClosureBudget& budget) {
  std::vector<const Json*> rows{budget.y, budget.ydot};
  std::erase(rows, nullptr);
  return rows;
}

std::vector<std::string> part_names(const std::vector<ClosureBudget>& budgets) {
  std::vector<std::string> names;
  for (const auto& budget : budgets) {
    for (const Json* row : rows_of(budget)) {
      // A name that is new stands before the one that follows it here: the chain's order.
      auto at = names.end();
      const Json& parts = row->at("parts");
      for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
        const auto name = part->at("name").get<std::string>();
        const auto known = std::ranges::find(names, name);
        at = known != names.end() ? known : names.insert(at, name);
      }
    }
  }
  return names;
}

const Json* find_part(const Json* row, const std::string& name) {
  if (row == nullptr) return nullptr;
  for (const auto& part : row->at("parts")) {
    if (part.at("name") == name) return &part;
  }
  return nullptr;
}

bool lies_between_references(const Json& part) {
  const auto from = part.at("from").get<std::string>();
  return from == "fd-kf" || from == "fd-kf limit";
}

}  // namespace fpkcheck::compare
