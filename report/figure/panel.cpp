#include "report/figure/panel.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "report/figure/gnuplot.hpp"

namespace fpkcheck::report {
namespace {

using transform::Variable;

std::string title(Panel panel, const FigureSide& side, const std::string& reference) {
  const bool of_y = side.variable == Variable::y;
  const auto variable = parameters::meaning_of(side.variable);
  switch (panel) {
    case Panel::linear:
      return fmt::format("({}) {}", of_y ? 'a' : 'c', variable);
    case Panel::logarithmic:
      return fmt::format("({}) {}, logarithmic", of_y ? 'b' : 'd', variable);
    case Panel::difference:
      return fmt::format("({}) {}, difference from {}", of_y ? 'e' : 'f', variable, reference);
    case Panel::smooth_difference:
      return fmt::format("({}) {}, |difference from {}|", of_y ? 'e' : 'f', variable, reference);
  }
  return "";
}

std::string axes(Panel panel, const FigureSide& side) {
  const FigureRanges& r = side.ranges;
  const bool in_the_tail = panel == Panel::logarithmic;
  const std::string variable = side.variable == Variable::y ? "{/:Italic y}" : "{/:Italic y}'";
  std::string density = "{/:Italic p}(" + variable + ")";
  std::string text =
      fmt::format("set xrange [{:.4g}:{:.4g}]\nset xlabel {}\n",
                  in_the_tail ? r.logarithmic_from : r.linear_from,
                  in_the_tail ? r.logarithmic_to : r.linear_to, gnuplot_string(variable));
  switch (panel) {
    case Panel::linear:
      text += fmt::format("set yrange [0:{:.4g}]\n", 1.08 * r.linear_top);
      if (const std::string beyond = beyond_the_top(r); !beyond.empty()) {
        text += fmt::format("set label 1 {} at first 0, graph 0.94 offset character 1,0\n",
                            gnuplot_literal(beyond));
      }
      break;
    case Panel::logarithmic:
      text +=
          fmt::format("set logscale y\nset format y '10^{{%T}}'\nset yrange [smallest:{:.4g}]\n",
                      3 * r.largest_density);
      break;
    case Panel::difference: {
      // Nothing but the reference itself: any range shows it.
      const double half = r.largest_difference > 0 ? 1.1 * r.largest_difference : 1;
      text += fmt::format("set yrange [{:.4g}:{:.4g}]\n", -half, half);
      density = "Δ" + density;
      break;
    }
    case Panel::smooth_difference: {
      const auto [from, to] = difference_decades(r);
      text += fmt::format("set logscale y\nset format y '10^{{%T}}'\nset yrange [{:.0e}:{:.0e}]\n",
                          from, to);
      density = "|Δ" + density + "|";
      break;
    }
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
      return with_interval ? "1:2:3:4" : "1:2";
    case Panel::smooth_difference:
      return "1:2";
  }
  return "";
}

std::string plot(Panel panel, const FigureSide& side) {
  // More points than these would hide the lines.
  constexpr std::size_t kPointsOnACurve = 35;
  std::vector<std::string> parts;
  const bool of_differences = panel == Panel::difference || panel == Panel::smooth_difference;
  for (const auto& drawn : side.curves) {
    const Difference& difference = drawn.difference;
    if (of_differences && difference.empty()) continue;
    const bool with_interval =
        panel != Panel::linear &&
        (of_differences ? !difference.lower.empty() : !drawn.curve->lower.empty());
    const auto points = (of_differences ? difference.abscissa : drawn.curve->abscissa).size();
    const auto step = std::max<std::size_t>(1, points / kPointsOnACurve);
    const std::string block =
        of_differences ? difference_block_name(side, drawn) : block_name(side, drawn);
    parts.push_back(fmt::format("{}{} using {} {} notitle", block,
                                drawn.look().as_points ? fmt::format(" every {}", step) : "",
                                using_columns(panel, with_interval),
                                drawn_with(drawn.look(), with_interval)));
  }
  return fmt::format("plot {}\n", fmt::join(parts, ", \\\n     "));
}

}  // namespace

std::string block_name(const FigureSide& side, const DrawnCurve& drawn) {
  // Begins with a letter, as it must; the place tells ids apart that differ in other marks alone.
  std::string name = fmt::format("{}{}_{}", transform::name(side.variable),
                                 &drawn - side.curves.data(), drawn.curve->solution);
  std::ranges::replace_if(
      name, [](unsigned char c) { return !std::isalnum(c); }, '_');
  return '$' + name;
}

std::string difference_block_name(const FigureSide& side, const DrawnCurve& drawn) {
  return block_name(side, drawn) + "_difference";
}

std::string drawn_with(const transform::Look& look, bool with_interval) {
  // A look may come from a file: it must not end its string, nor be a command.
  const std::string colour = gnuplot_string(look.colour);
  if (look.as_points) {
    return fmt::format("with {} pointtype 6 pointsize dot linewidth {} linecolor rgb {}",
                       with_interval ? "yerrorbars" : "points", look.width, colour);
  }
  const bool lengths = look.dash.find_first_not_of("(),.0123456789") == std::string::npos;
  return fmt::format("with lines linewidth {} dashtype {} linecolor rgb {}", look.width,
                     lengths && !look.dash.empty() ? look.dash : "solid", colour);
}

std::string panel_commands(Panel panel, const FigureSide& side, const std::string& reference) {
  return fmt::format("set title {}\n", gnuplot_literal(title(panel, side, reference))) +
         axes(panel, side) + plot(panel, side) + "unset label 1\nunset logscale\nset format y\n\n";
}

}  // namespace fpkcheck::report
