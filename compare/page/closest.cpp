#include "compare/page/closest.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "compare/page/number_text.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
using transform::Variable;

double distance(const Json& summary_case, std::string_view id, std::string_view reference) {
  const auto y = l1_between(summary_case, id, reference, Variable::y);
  const auto ydot = l1_between(summary_case, id, reference, Variable::ydot);
  return y && ydot ? *y + *ydot : std::numeric_limits<double>::infinity();
}

}  // namespace

std::string reference_of(const Json& summary_case) {
  for (const std::string id : {"fd-kf", "mcs"}) {
    if (usable(summary_case, id)) return id;
  }
  return "";
}

std::vector<std::string> closures_by_distance(const Json& summary_case) {
  std::vector<std::string> ids;
  for (const auto& solution : summary_case.at("solutions")) {
    if (solution.at("method") == "epc" && is_ok(solution)) ids.push_back(solution.at("id"));
  }
  const std::string reference = reference_of(summary_case);
  std::ranges::stable_sort(ids, {},
                           [&](const auto& id) { return distance(summary_case, id, reference); });
  return ids;
}

std::vector<std::string> first_shown(const Json& summary_case) {
  std::vector<std::string> ids;
  std::set<std::string> formulations;
  for (const auto& id : closures_by_distance(summary_case)) {
    if (formulations.insert(word(*find_solution(summary_case, id), "formulation")).second) {
      ids.push_back(id);
    }
  }
  for (const std::string id : {"fd-kf", "mcs"}) {
    if (usable(summary_case, id)) ids.push_back(id);
  }
  if (ids.size() >= 2) return ids;
  ids.clear();
  for (const auto& solution : summary_case.at("solutions")) ids.push_back(solution.at("id"));
  return ids;
}

}  // namespace fpkcheck::compare
