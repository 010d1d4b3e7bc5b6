#include "report/figure/panel.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "report/figure/gnuplot.hpp"
#include "report/figure/script_text.hpp"

namespace fpkcheck::report {
namespace {

using transform::Variable;

std::string title(Panel panel, const MarginalCurves& marginal, char letter,
                  const std::string& reference, bool short_title) {
  const std::string variable(base::meaning_of(marginal.variable));
  const auto named = [&](const std::string& what) {
    return fmt::format("({}) {}{}", letter, short_title ? "" : variable + ", ", what);
  };
  switch (panel) {
    case Panel::linear:
      return fmt::format("({}) {}", letter, variable);
    case Panel::logarithmic:
      return short_title ? fmt::format("({}) {}", letter, variable) : named("logarithmic");
    case Panel::difference:
      return named("difference from " + reference);
    case Panel::smooth_difference:
      return named("|difference from " + reference + "|");
  }
  return "";
}

std::string axes(Panel panel, const MarginalCurves& marginal) {
  const MarginalAxisRanges& r = marginal.ranges;
  const bool is_logarithmic = panel == Panel::logarithmic;
  const double from = is_logarithmic ? r.logarithmic_from : r.linear_from,
               to = is_logarithmic ? r.logarithmic_to : r.linear_to;
  const std::string variable = marginal.variable == Variable::y ? "{/:Italic y}" : "{/:Italic y}'";
  std::string density = "{/:Italic p}(" + variable + ")";
  std::string text =
      fmt::format("set xrange [{:.4g}:{:.4g}]\nset xlabel {}\n", from, to, gnuplot_text(variable));
  text += fmt::format("set xtics {:g}\n", tic_step(from, to));
  switch (panel) {
    case Panel::linear:
      text += fmt::format("set yrange [0:{:.4g}]\n", 1.08 * r.linear_top);
      if (const std::string beyond = spike_note(r); !beyond.empty()) {
        text += fmt::format("set label 1 {} at first 0, graph 0.94 offset character 1,0\n",
                            gnuplot_literal(beyond));
      }
      break;
    case Panel::logarithmic:
      text += fmt::format(
          "smallest = {:.4g}\nset logscale y\nset format y {}\nset yrange [smallest:{:.4g}]\n",
          logarithmic_axis_bottom(r), kPowerOfTenFormat, logarithmic_axis_top(r));
      break;
    case Panel::difference: {
      // If all differences are 0, as for the reference alone, the range is arbitrary.
      const double half = r.largest_difference > 0 ? 1.1 * r.largest_difference : 1;
      text += fmt::format("set yrange [{:.4g}:{:.4g}]\n", -half, half);
      density = "Δ" + density;
      break;
    }
    case Panel::smooth_difference: {
      const auto [least, most] = difference_axis_decades(r);
      text += fmt::format("set logscale y\nset format y {}\nset yrange [{:.0e}:{:.0e}]\n",
                          kPowerOfTenFormat, least, most);
      density = "|Δ" + density + "|";
      break;
    }
  }
  return text + fmt::format("set ylabel {}\n", gnuplot_text(density));
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

std::string plot(Panel panel, const MarginalCurves& marginal, const std::string& reference) {
  // The number of points of a simulation's curve is limited, since more points would hide the lines
  // of other curves. A curve that is drawn as a line has fewer marks.
  constexpr std::size_t kPointsOnACurve = 35, kMarksOnACurve = 8;
  std::vector<std::string> parts;
  const bool of_differences = panel == Panel::difference || panel == Panel::smooth_difference;
  const auto marked =
      std::max<std::size_t>(1, std::ranges::count_if(marginal.curves, [](const DrawnCurve& drawn) {
                              return has_marks(drawn.solution->identity);
                            }));
  std::size_t place = 0;  // index among the curves with marks
  for (const auto& drawn : marginal.curves) {
    const CurveDifference& difference = drawn.difference;
    if (of_differences && difference.empty()) continue;
    const bool with_interval =
        panel != Panel::linear &&
        (of_differences ? !difference.lower.empty() : !drawn.curve->lower.empty());
    const auto points = (of_differences ? difference.abscissa : drawn.curve->abscissa).size();
    const std::string block =
        of_differences ? difference_block_name(marginal, drawn) : block_name(marginal, drawn);
    const bool is_reference_interval =
        panel == Panel::smooth_difference && drawn.solution->id() == reference;
    const bool as_points = drawn.plot_style().as_points && !is_reference_interval;
    const auto step = std::max<std::size_t>(1, points / kPointsOnACurve);
    parts.push_back(fmt::format(
        "{}{} using {} {} notitle", block, as_points ? fmt::format(" every {}", step) : "",
        using_columns(panel, with_interval),
        is_reference_interval ? kReferenceIntervalStyle
                              : curve_style(drawn.plot_style(), with_interval)));
    if (as_points || is_reference_interval || !has_marks(drawn.solution->identity)) continue;
    // The marks of different curves have different abscissae, since the curves may nearly coincide.
    const auto between = std::max<std::size_t>(1, points / kMarksOnACurve);
    parts.push_back(fmt::format("{} every {}::{} using {} with points {} linecolor rgb {} notitle",
                                block, between, place++ * between / marked,
                                using_columns(panel, false), mark_style(*drawn.solution),
                                gnuplot_string(drawn.plot_style().colour)));
  }
  return fmt::format("plot {}\n", fmt::join(parts, ", \\\n     "));
}

}  // namespace

std::string block_name(const MarginalCurves& marginal, const DrawnCurve& drawn) {
  // The name of a data block must begin with a letter in gnuplot. The index keeps names distinct if
  // ids differ only in replaced characters.
  std::string name = fmt::format("{}{}_{}", transform::name(marginal.variable),
                                 &drawn - marginal.curves.data(), drawn.curve->solution);
  std::ranges::replace_if(
      name, [](unsigned char c) { return !std::isalnum(c); }, '_');
  return '$' + name;
}

std::string difference_block_name(const MarginalCurves& marginal, const DrawnCurve& drawn) {
  return block_name(marginal, drawn) + "_difference";
}

std::string curve_style(const transform::PlotStyle& plot_style, bool with_interval) {
  // A style may come from a file: quoting prevents that a quotation mark in the style ends the
  // string and injects commands.
  const std::string colour = gnuplot_string(plot_style.colour);
  if (plot_style.as_points) {
    return fmt::format("with {} pointtype 6 pointsize dot linewidth {} linecolor rgb {}",
                       with_interval ? "yerrorbars" : "points", plot_style.width, colour);
  }
  return fmt::format("with lines linewidth {} dashtype {} linecolor rgb {}", plot_style.width,
                     dash_type(plot_style.dash), colour);
}

bool has_marks(const transform::SolutionIdentity& identity) {
  return !identity.plot_style.as_points && (identity.role == transform::SolutionRole::closure ||
                                            identity.role == transform::SolutionRole::external);
}

std::string mark_style(const transform::Solution& solution) {
  const auto [filled, open] = point_types(solution.identity.plot_style.symbol);
  return fmt::format("pointtype {} pointsize mark", solution.is_ok() ? filled : open);
}

std::string panel_commands(Panel panel, const MarginalCurves& marginal, char letter,
                           const std::string& reference, bool short_title) {
  return fmt::format("set title {}\n",
                     gnuplot_literal(title(panel, marginal, letter, reference, short_title))) +
         axes(panel, marginal) + plot(panel, marginal, reference) +
         "unset label 1\nunset logscale\nset format y\n\n";
}

}  // namespace fpkcheck::report
