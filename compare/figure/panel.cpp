#include "compare/figure/panel.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "compare/figure/gnuplot.hpp"

namespace fpkcheck::compare {
namespace {

std::string title(Panel panel, const FigureSide& side, const std::string& reference) {
  const bool of_y = side.variable == "y";
  const std::string variable = of_y ? "displacement" : "velocity";
  switch (panel) {
    case Panel::linear:
      return fmt::format("({}) {}", of_y ? 'a' : 'c', variable);
    case Panel::logarithmic:
      return fmt::format("({}) {}, logarithmic", of_y ? 'b' : 'd', variable);
    case Panel::difference:
      return fmt::format("({}) {}, difference from {}", of_y ? 'e' : 'f', variable, reference);
  }
  return "";
}

std::string axes(Panel panel, const FigureSide& side) {
  const FigureRanges& r = side.ranges;
  const bool in_the_tail = panel == Panel::logarithmic;
  const std::string variable = side.variable == "y" ? "{/:Italic y}" : "{/:Italic y}'";
  std::string density = "{/:Italic p}(" + variable + ")";
  std::string text =
      fmt::format("set xrange [{:.4g}:{:.4g}]\nset xlabel {}\n",
                  in_the_tail ? r.logarithmic_from : r.linear_from,
                  in_the_tail ? r.logarithmic_to : r.linear_to, gnuplot_string(variable));
  switch (panel) {
    case Panel::linear:
      text += fmt::format("set yrange [0:{:.4g}]\n", 1.08 * r.largest_density);
      break;
    case Panel::logarithmic:
      text +=
          fmt::format("set logscale y\nset format y '10^{{%T}}'\nset yrange [smallest:{:.4g}]\n",
                      3 * r.largest_density);
      break;
    case Panel::difference:
      // Nothing but the reference itself: any range shows it.
      const double half = r.largest_difference > 0 ? 1.1 * r.largest_difference : 1;
      text += fmt::format("set yrange [{:.4g}:{:.4g}]\n", -half, half);
      density = "Δ" + density;
      break;
  }
  return text + fmt::format("set ylabel {}\n", gnuplot_string(density));
}

std::string using_columns(Panel panel, bool with_interval) {
  switch (panel) {
    case Panel::linear:
      return "1:2";
    case Panel::logarithmic:
      return with_interval ? "1:(positive($2)):(at_least_smallest($3)):4" : "1:(positive($2))";
    case Panel::difference:
      return with_interval ? "1:5:($5+$3-$2):($5+$4-$2)" : "1:5";
  }
  return "";
}

std::string plot(Panel panel, const FigureSide& side) {
  // More points than these would hide the lines.
  constexpr std::size_t kPointsOnACurve = 35;
  std::vector<std::string> parts;
  for (const auto& drawn : side.curves) {
    if (panel == Panel::difference && drawn.difference.empty()) continue;
    const bool with_interval = panel != Panel::linear && !drawn.curve->lower.empty();
    const auto step = std::max<std::size_t>(1, drawn.curve->abscissa.size() / kPointsOnACurve);
    parts.push_back(fmt::format("{}{} using {} {} notitle", block_name(*drawn.curve),
                                drawn.style.as_points ? fmt::format(" every {}", step) : "",
                                using_columns(panel, with_interval),
                                drawn_with(drawn.style, with_interval)));
  }
  return fmt::format("plot {}\n", fmt::join(parts, ", \\\n     "));
}

}  // namespace

std::string block_name(const MarginalCurve& curve) {
  std::string name = "$" + curve.solution + "_" + curve.variable;
  std::replace_if(
      name.begin() + 1, name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

std::string drawn_with(const CurveStyle& style, bool with_interval) {
  if (style.as_points) {
    return fmt::format("with {} pointtype 6 pointsize dot linewidth {} linecolor rgb '{}'",
                       with_interval ? "yerrorbars" : "points", style.width, style.colour);
  }
  return fmt::format("with lines linewidth {} dashtype {} linecolor rgb '{}'", style.width,
                     style.dash, style.colour);
}

std::string panel_commands(Panel panel, const FigureSide& side, const std::string& reference) {
  return fmt::format("set title {}\n", gnuplot_literal(title(panel, side, reference))) +
         axes(panel, side) + plot(panel, side) + "unset logscale\nset format y\n\n";
}

}  // namespace fpkcheck::compare
