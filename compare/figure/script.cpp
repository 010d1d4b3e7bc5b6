#include "compare/figure/script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <set>

#include "compare/figure/frame.hpp"
#include "compare/figure/gnuplot.hpp"
#include "compare/figure/panel.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

// Fractions of the picture's height and width.
constexpr double kTop = 0.91, kLegendTop = 0.13, kLeft = 0.055, kRight = 0.99;
constexpr double kColumnGap = 0.075, kRowGap = 0.125, kAxisLabels = 0.065;

std::string data_block(const DrawnCurve& drawn) {
  const MarginalCurve& curve = *drawn.curve;
  const auto at = [](const std::vector<double>& values, std::size_t k) {
    return values.empty() ? std::numeric_limits<double>::quiet_NaN() : values[k];
  };
  std::string text = block_name(curve) + " << EOD\n";
  for (std::size_t k = 0; k < curve.abscissa.size(); ++k) {
    text += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g} {:.6g}\n", curve.abscissa[k], curve.density[k],
                        at(curve.lower, k), at(curve.upper, k), at(drawn.difference, k));
  }
  return text + "EOD\n";
}

std::string data(const FigureContent& content) {
  std::string text = fmt::format(
      "# Columns: abscissa, density, lower and upper end of its 95 % interval, difference{}{}\n",
      content.reference.empty() ? "" : " from ", content.reference);
  for (const auto& side : content.sides) {
    for (const auto& drawn : side.curves) text += data_block(drawn);
  }
  return text;
}

std::string settings() {
  return fmt::format(
      "\n"
      "smallest = {}\n"
      "positive(p) = p > 0 ? p : NaN\n"
      "at_least_smallest(p) = p > smallest ? p : smallest\n"
      "set grid linetype 1 dashtype solid linecolor rgb '#DDDDDD' linewidth 0.6\n"
      "set tics nomirror\n"
      "set border 3\n\n",
      kSmallestDrawnDensity);
}

std::string panels(const FigureContent& content) {
  std::vector<Panel> shown{Panel::linear, Panel::logarithmic};
  if (!content.reference.empty()) shown.push_back(Panel::difference);
  const double columns = static_cast<double>(shown.size());
  const double rows = static_cast<double>(content.sides.size());
  const double width = (kRight - kLeft - (columns - 1) * kColumnGap) / columns;
  const double height = (kTop - kLegendTop - kAxisLabels - (rows - 1) * kRowGap) / rows;
  std::string text;
  for (std::size_t row = 0; row < content.sides.size(); ++row) {
    const double top = kTop - static_cast<double>(row) * (height + kRowGap);
    for (std::size_t column = 0; column < shown.size(); ++column) {
      const double left = kLeft + static_cast<double>(column) * (width + kColumnGap);
      text += fmt::format(
          "set lmargin at screen {:.4f}\n"
          "set rmargin at screen {:.4f}\n"
          "set tmargin at screen {:.4f}\n"
          "set bmargin at screen {:.4f}\n",
          left, left + width, top, top - height);
      text += panel_commands(shown[column], content.sides[row], content.reference);
    }
  }
  return text;
}

std::string legend_label(const DrawnCurve& drawn) {
  const Json& solution = *drawn.solution;
  auto label = solution.at("id").get<std::string>();
  if (!is_ok(solution)) label += fmt::format(" ({})", solution.at("status").get<std::string>());
  if (!drawn.curve->lower.empty()) label += ", with 95 % intervals";
  return label;
}

// A strip of its own below the panels, so that no curve is covered.
std::string legend(const FigureContent& content) {
  std::set<std::string> listed;
  std::vector<std::string> parts;
  for (const auto& side : content.sides) {
    for (const auto& drawn : side.curves) {
      if (!listed.insert(drawn.curve->solution).second) continue;
      const bool with_interval = !drawn.curve->lower.empty();
      parts.push_back(fmt::format(
          "{} {} title {}", with_interval ? "'+' using 1:(NaN):(0):(0)" : "NaN",
          drawn_with(drawn.style, with_interval), gnuplot_literal(legend_label(drawn))));
    }
  }
  return fmt::format(
      "unset title\n"
      "unset xlabel\n"
      "unset ylabel\n"
      "unset border\n"
      "unset tics\n"
      "unset grid\n"
      "set lmargin at screen 0.02\n"
      "set rmargin at screen 0.98\n"
      "set tmargin at screen {:.4f}\n"
      "set bmargin at screen 0.005\n"
      "set key center center horizontal maxcols 4 Left reverse samplen 5 spacing 1.2\n"
      "plot [0:1] [0:1] {}\n",
      kLegendTop - 0.035, fmt::join(parts, ", \\\n     "));
}

}  // namespace

std::string figure_script(const Json& summary_case, const FigureContent& content,
                          const std::string& file_stem) {
  return figure_output(file_stem, {.width = 1500, .height = 950}) +
         "dot = format eq 'svg' ? 0.45 : 0.6\n\n" + data(content) + settings() +
         fmt::format("set multiplot title {} font ',14'\n\n", figure_title(summary_case)) +
         panels(content) + legend(content) + "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::compare
