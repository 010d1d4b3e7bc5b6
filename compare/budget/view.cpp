#include "compare/budget/view.hpp"

#include <algorithm>

#include "compare/summary_view.hpp"

namespace fpkcheck::compare {

using Json = nlohmann::ordered_json;

std::vector<ClosureBudget> closure_budgets(const Json& summary_case) {
  std::vector<ClosureBudget> budgets;
  const auto budget = summary_case.find("budget");
  if (budget == summary_case.end()) return budgets;
  for (const auto& row : *budget) {
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

// Hues of Okabe and Ito, which colour-blind readers tell apart.
const char* part_colour(const std::string& name) {
  if (name == "closure") return "#D55E00";
  if (name == "impact") return "#E69F00";
  if (name == "truncation") return "#0072B2";
  if (name == "white noise") return "#009E73";
  if (name == "discretisation") return "#56B4E9";
  if (name == "sampling") return "#CC79A7";
  return "#999999";
}

bool lies_between_references(const Json& part) {
  const auto from = part.at("from").get<std::string>();
  return from == "fd-kf" || from == "fd-kf limit";
}

}  // namespace fpkcheck::compare
