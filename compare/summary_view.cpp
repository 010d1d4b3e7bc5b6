#include "compare/summary_view.hpp"

namespace fpkcheck::compare {

using Json = nlohmann::ordered_json;

std::string said_by(const Json::exception& error) {
  const std::string text = error.what();
  const auto end = text.find("] ");
  return end == std::string::npos ? text : text.substr(end + 2);
}

std::optional<double> number(const Json& object, std::string_view key) {
  if (!object.is_object()) return std::nullopt;
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

const Json* find_solution(const Json& summary_case, std::string_view id) {
  for (const auto& solution : summary_case.at("solutions")) {
    if (solution.at("id") == id) return &solution;
  }
  return nullptr;
}

bool is_ok(const Json& solution) { return solution.at("status") == "ok"; }

bool usable(const Json& summary_case, std::string_view id) {
  const Json* solution = find_solution(summary_case, id);
  return solution != nullptr && is_ok(*solution);
}

std::optional<double> l1_between(const Json& summary_case, std::string_view one,
                                 std::string_view other, transform::Variable variable) {
  for (const auto& comparison : summary_case.at("comparisons")) {
    const auto& a = comparison.at("a");
    const auto& b = comparison.at("b");
    const bool same_pair = (a == one && b == other) || (a == other && b == one);
    if (same_pair && comparison.at("variable") == transform::name(variable)) {
      return number(comparison, "l1");
    }
  }
  return std::nullopt;
}

}  // namespace fpkcheck::compare
