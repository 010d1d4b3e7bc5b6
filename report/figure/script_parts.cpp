#include "report/figure/script_parts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>

namespace fpkcheck::report {

std::string panel_position_commands(const PanelBox& place) {
  return fmt::format(
      "set lmargin at screen {:.4g}\nset rmargin at screen {:.4g}\n"
      "set tmargin at screen {:.4g}\nset bmargin at screen {:.4g}\n",
      place.left, place.right, place.top, place.bottom);
}

std::string data_block(const std::string& name, const std::string& rows) {
  return fmt::format("${} << EOD\n{}EOD\n", name, rows);
}

double tic_step(double from, double to, int max_steps) {
  const double least = (to - from) / max_steps;
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * power >= least) return digit * power;
  }
  return 10 * power;
}

std::string density_symbol(transform::Variable variable) {
  return variable == transform::Variable::y ? "{/:Italic p}({/:Italic y})"
                                            : "{/:Italic p}({/:Italic y}')";
}

PointTypes point_types(const std::string& symbol) {
  constexpr std::string_view kOpen = "-open";
  if (symbol.ends_with(kOpen)) {
    const int open = point_types(symbol.substr(0, symbol.size() - kOpen.size())).open;
    return {open, open};
  }
  constexpr std::pair<std::string_view, PointTypes> kShapes[] = {
      {"cross", {1, 1}},     {"asterisk", {3, 3}},    {"circle", {7, 6}},
      {"square", {5, 4}},    {"triangle-up", {9, 8}}, {"triangle-down", {11, 10}},
      {"diamond", {13, 12}}, {"pentagon", {15, 14}}};
  for (const auto& [shape, types] : kShapes) {
    if (shape == symbol) return types;
  }
  constexpr int kCross = 2, kPlus = 1;
  return {kCross, kPlus};
}

std::string dash_type(const std::string& dash) {
  const bool lengths = dash.find_first_not_of("(),.0123456789") == std::string::npos;
  return lengths && !dash.empty() ? dash : "solid";
}

std::vector<SeriesStyle> series_styles(std::span<const transform::SolutionIdentity> identities) {
  std::vector<SeriesStyle> looks;
  for (const auto& one : identities) {
    const auto [filled, open] = point_types(one.plot_style.symbol);
    looks.push_back({one.plot_style.colour, filled, open, dash_type(one.plot_style.dash)});
  }
  return looks;
}

}  // namespace fpkcheck::report
