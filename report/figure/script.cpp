#include "report/figure/script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <set>

#include "report/figure/frame.hpp"
#include "report/figure/legend_strip.hpp"
#include "report/figure/panel.hpp"

namespace fpkcheck::report {
namespace {

constexpr int kWidth = 1500;
// Fractions of the width, and pixels from the top: the first and the last end of a panel, and the
// legend.
constexpr double kLeft = 0.055, kRight = 0.99, kColumnGap = 0.075;
constexpr double kTop = 86, kBottom = 765, kRowGap = 119;
constexpr int kLegendTop = 860;

std::string data_block(const std::string& name, const std::vector<double>& abscissa,
                       const std::vector<double>& values, const std::vector<double>& lower,
                       const std::vector<double>& upper) {
  const auto at = [](const std::vector<double>& of, std::size_t k) {
    return of.empty() ? std::numeric_limits<double>::quiet_NaN() : of[k];
  };
  std::string text = name + " << EOD\n";
  for (std::size_t k = 0; k < abscissa.size(); ++k) {
    text += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", abscissa[k], values[k], at(lower, k),
                        at(upper, k));
  }
  return text + "EOD\n";
}

std::string data(const FigureContent& content) {
  std::string text =
      "# Columns: abscissa, density or its difference from the reference, lower and upper end of "
      "the 95 % interval\n";
  for (const auto& side : content.sides) {
    for (const auto& drawn : side.curves) {
      const results::Curve& c = *drawn.curve;
      const Difference& d = drawn.difference;
      text += data_block(block_name(side, drawn), c.abscissa, c.density, c.lower, c.upper);
      if (d.empty()) continue;
      text +=
          data_block(difference_block_name(side, drawn), d.abscissa, d.values, d.lower, d.upper);
    }
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

std::string panels(const FigureContent& content, const FigureSize& size) {
  std::vector<Panel> shown{Panel::linear, Panel::logarithmic};
  if (!content.reference.empty()) {
    shown.push_back(content.smooth_differences ? Panel::smooth_difference : Panel::difference);
  }
  const double columns = static_cast<double>(shown.size());
  const double rows = static_cast<double>(content.sides.size());
  const double width = (kRight - kLeft - (columns - 1) * kColumnGap) / columns;
  const double height = (kBottom - kTop - (rows - 1) * kRowGap) / rows;
  std::string text;
  for (std::size_t row = 0; row < content.sides.size(); ++row) {
    const double top = kTop + static_cast<double>(row) * (height + kRowGap);
    for (std::size_t column = 0; column < shown.size(); ++column) {
      const double left = kLeft + static_cast<double>(column) * (width + kColumnGap);
      text += fmt::format(
          "set lmargin at screen {:.4f}\n"
          "set rmargin at screen {:.4f}\n"
          "set tmargin at screen {:.4f}\n"
          "set bmargin at screen {:.4f}\n",
          left, left + width, 1 - top / size.height, 1 - (top + height) / size.height);
      text += panel_commands(shown[column], content.sides[row], content.reference);
    }
  }
  return text;
}

std::string legend_label(const DrawnCurve& drawn) {
  const auto& solution = *drawn.solution;
  std::string label = solution.id();
  if (!solution.is_ok()) label += fmt::format(" ({})", name(solution.status));
  if (!drawn.curve->lower.empty()) label += ", with 95 % intervals";
  return label;
}

Legend legend(const FigureContent& content) {
  Legend legend{{}, 5};
  std::set<std::string> listed;
  for (const auto& side : content.sides) {
    for (const auto& drawn : side.curves) {
      if (!listed.insert(drawn.curve->solution).second) continue;
      const bool with_interval = !drawn.curve->lower.empty();
      legend.entries.push_back(
          {fmt::format("{} {}", with_interval ? "'+' using 1:(NaN):(0):(0)" : "NaN",
                       drawn_with(drawn.look(), with_interval)),
           legend_label(drawn)});
    }
  }
  return legend;
}

}  // namespace

std::string figure_script(const problem::Problem& problem, const FigureContent& content,
                          const std::string& file_stem) {
  const Legend entries = legend(content);
  const FigureSize size{.width = kWidth, .height = kLegendTop + legend_height(entries, kWidth)};
  return figure_output(file_stem, size) + "dot = format eq 'svg' ? 0.45 : 0.6\n\n" + data(content) +
         settings() + fmt::format("set multiplot title {} font ',14'\n\n", figure_title(problem)) +
         panels(content, size) + legend_strip(entries, size) + "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::report
