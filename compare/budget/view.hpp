#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

/// Questions that the sentence, the table and the picture ask of a saved budget.
namespace fpkcheck::compare {

/// The budget of one closure in both variables, pointing into summary.json.
struct ClosureBudget {
  std::string solution;
  std::string status;  ///< of the closure
  const nlohmann::ordered_json* y = nullptr;
  const nlohmann::ordered_json* ydot = nullptr;  ///< null where a variable has none
};

/// The closures of "budget", in its order; none in a summary without one.
std::vector<ClosureBudget> closure_budgets(const nlohmann::ordered_json& summary_case);

/// The rows of a closure that are there.
std::vector<const nlohmann::ordered_json*> rows_of(const ClosureBudget& budget);

/// Names of all parts, in the order of the chain.
std::vector<std::string> part_names(const std::vector<ClosureBudget>& budgets);

/// The part of this name in a row of "budget", or null.
const nlohmann::ordered_json* find_part(const nlohmann::ordered_json* row, const std::string& name);

/// The colour of a part in every picture; several links together are grey.
const char* part_colour(const std::string& name);

/// True for what every closure's chain ends with: discretisation and sampling of the references.
bool lies_between_references(const nlohmann::ordered_json& part);

}  // namespace fpkcheck::compare
