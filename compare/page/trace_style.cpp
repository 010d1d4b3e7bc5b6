#include "compare/page/trace_style.hpp"

#include <fmt/format.h>

#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

// gnuplot's "(10,4,2,4)" is "10px,4px,2px,4px".
std::string dash_of(const std::string& gnuplot_dash) {
  std::string dash;
  for (const char c : gnuplot_dash) {
    if (c == ',' || c == ')') dash += "px";
    if (c != '(' && c != ')') dash += c;
  }
  return dash;
}

}  // namespace

nlohmann::ordered_json line_of(const CurveStyle& style) {
  return {{"color", style.colour}, {"width", style.width}, {"dash", dash_of(style.dash)}};
}

std::string legend_name(const nlohmann::ordered_json& solution) {
  const auto id = solution.at("id").get<std::string>();
  if (is_ok(solution)) return id;
  return fmt::format("{} ({})", id, solution.at("status").get<std::string>());
}

}  // namespace fpkcheck::compare
