#include "compare/budget/figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "compare/budget/view.hpp"
#include "compare/figure/frame.hpp"
#include "compare/figure/gnuplot.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

// Fractions of the picture's width and height, and of the unit between two closures.
constexpr double kLefts[] = {0.065, 0.565}, kPanelWidth = 0.42;
constexpr double kTops[] = {0.915, 0.49}, kPanelHeight = 0.295, kLegendTop = 0.075;
constexpr double kGroupWidth = 0.8;
// Parts that are smaller than this share of the largest total would stretch the axis for nothing.
constexpr double kSmallestShare = 1e-4;

/// One panel: a variable, and one of the two measures.
struct Panel {
  const char* title;
  const char* label;
  const Json* ClosureBudget::*variable;
  const char* total;  ///< key of a row
  const char* part;   ///< key of a part
  const char* block;  ///< its prefix of data blocks
  int column, row;
};
constexpr std::array kPanels{
    Panel{"(a) displacement {/:Italic p}({/:Italic y})", "{/:Italic L}_1 distance",
          &ClosureBudget::y, "total", "l1", "y_l1", 0, 0},
    Panel{"(b) displacement, tail: 10^{-5} ≤ {/:Italic p} < 10^{-3}", "mean |log_{10} ratio|",
          &ClosureBudget::y, "total_tail", "tail", "y_tail", 1, 0},
    Panel{"(c) velocity {/:Italic p}({/:Italic y}')", "{/:Italic L}_1 distance",
          &ClosureBudget::ydot, "total", "l1", "v_l1", 0, 1},
    Panel{"(d) velocity, tail: 10^{-5} ≤ {/:Italic p} < 10^{-3}", "mean |log_{10} ratio|",
          &ClosureBudget::ydot, "total_tail", "tail", "v_tail", 1, 1}};

std::string block(const Panel& panel, std::size_t part, bool ok) {
  return fmt::format("${}_{}{}", panel.block, part, ok ? "" : "_not_ok");
}

std::string totals_block(const Panel& panel) { return fmt::format("${}_total", panel.block); }

/// A bar: where it stands among the closures 1, 2, .. and how wide it is.
struct Bar {
  double centre, width, value;
};

// The bars of a closure share the width of its group, whatever their number.
std::vector<std::pair<std::string, Bar>> bars(const Panel& panel, const ClosureBudget& budget,
                                              std::size_t place) {
  std::vector<std::pair<std::string, Bar>> result;
  const Json* row = budget.*panel.variable;
  if (row == nullptr) return result;
  const Json& parts = row->at("parts");
  const double width = kGroupWidth / static_cast<double>(parts.size());
  double left = static_cast<double>(place) + 1 - kGroupWidth / 2;
  for (const auto& part : parts) {
    result.push_back({part.at("name").get<std::string>(),
                      {left + width / 2, width, number(part, panel.part).value_or(0)}});
    left += width;
  }
  return result;
}

std::string data(const Panel& panel, const std::vector<ClosureBudget>& budgets,
                 const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t n = 0; n < names.size(); ++n) {
    for (const bool ok : {true, false}) {
      text += block(panel, n, ok) + " << EOD\n";
      for (std::size_t place = 0; place < budgets.size(); ++place) {
        if ((budgets[place].status == "ok") != ok) continue;
        for (const auto& [name, bar] : bars(panel, budgets[place], place)) {
          if (name != names[n] || !(bar.value > 0)) continue;
          text += fmt::format("{:.4f} {:.6g} {:.4f}\n", bar.centre, bar.value, bar.width);
        }
      }
      text += "EOD\n";
    }
  }
  text += totals_block(panel) + " << EOD\n";
  for (std::size_t place = 0; place < budgets.size(); ++place) {
    const Json* row = budgets[place].*panel.variable;
    const auto total = row ? number(*row, panel.total) : std::nullopt;
    if (total && *total > 0) {
      text += fmt::format("{:.4f} {:.6g} {:.4f}\n",
                          static_cast<double>(place) + 1 - kGroupWidth / 2, *total, kGroupWidth);
    }
  }
  return text + "EOD\n";
}

/// The decades that hold all bars that matter.
struct Range {
  double from, to;
};
Range range(const Panel& panel, const std::vector<ClosureBudget>& budgets) {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  const auto include = [&](double value) {
    if (!(value > 0)) return;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  };
  for (std::size_t place = 0; place < budgets.size(); ++place) {
    for (const auto& [name, bar] : bars(panel, budgets[place], place)) include(bar.value);
    const Json* row = budgets[place].*panel.variable;
    if (row) include(number(*row, panel.total).value_or(0));
  }
  if (greatest == 0) return {1e-5, 1};
  const double from = std::max(least, kSmallestShare * greatest);
  // The lowest bar keeps some height.
  return {std::pow(10, std::floor(std::log10(0.8 * from))),
          std::pow(10, std::ceil(std::log10(1.2 * greatest)))};
}

std::string short_name(const ClosureBudget& budget) {
  constexpr std::string_view kPrefix = "epc-";
  std::string name = budget.solution;
  if (name.starts_with(kPrefix)) name.erase(0, kPrefix.size());
  return budget.status == "ok" ? name : name + " *";
}

std::string axes(const Panel& panel, const std::vector<ClosureBudget>& budgets) {
  std::vector<std::string> tics;
  for (std::size_t place = 0; place < budgets.size(); ++place) {
    tics.push_back(fmt::format("{} {}", gnuplot_literal(short_name(budgets[place])), place + 1));
  }
  const double left = kLefts[panel.column], top = kTops[panel.row];
  const Range y = range(panel, budgets);
  return fmt::format(
      "set title \"{}\"\nset ylabel \"{}\"\n"
      "set lmargin at screen {:.3f}\nset rmargin at screen {:.3f}\n"
      "set tmargin at screen {:.3f}\nset bmargin at screen {:.3f}\n"
      "set xtics ({}) rotate by 35 right\n"
      "set xrange [0.4:{:.1f}]\nset yrange [{:g}:{:g}]\n",
      panel.title, panel.label, left, left + kPanelWidth, top, top - kPanelHeight,
      fmt::join(tics, ", "), static_cast<double>(budgets.size()) + 0.6, y.from, y.to);
}

std::string plot(const Panel& panel, const std::vector<std::string>& names) {
  std::vector<std::string> plots;
  for (std::size_t n = 0; n < names.size(); ++n) {
    for (const bool ok : {true, false}) {
      plots.push_back(fmt::format(
          "{} using 1:2:3 with boxes fillstyle solid {} border rgb '{}' linecolor rgb "
          "'{}' notitle",
          block(panel, n, ok), ok ? 1.0 : 0.3, part_colour(names[n]), part_colour(names[n])));
    }
  }
  plots.push_back(totals_block(panel) +
                  " using 1:2:3:(0) with vectors nohead linewidth 2.5 linecolor rgb '#000000' "
                  "notitle");
  return fmt::format("plot {}\n\n", fmt::join(plots, ", \\\n     "));
}

// A strip of its own below the panels, so that no bar is covered.
std::string legend(const std::vector<std::string>& names, bool any_not_ok) {
  std::vector<std::string> parts;
  for (const auto& name : names) {
    parts.push_back(fmt::format("NaN with boxes fillstyle solid linecolor rgb '{}' title {}",
                                part_colour(name), gnuplot_literal(name)));
  }
  parts.emplace_back("NaN with lines linewidth 2.5 linecolor rgb '#000000' title 'total'");
  if (any_not_ok) {
    parts.emplace_back(
        "NaN with boxes fillstyle solid 0.3 linecolor rgb '#000000' title '* no admissible density'");
  }
  return fmt::format(
      "unset title\nunset xlabel\nunset ylabel\nunset border\nunset tics\nunset grid\n"
      "unset logscale\n"
      "set lmargin at screen 0.02\nset rmargin at screen 0.98\n"
      "set tmargin at screen {:.3f}\nset bmargin at screen 0.005\n"
      "set key center center horizontal maxrows 2 Left reverse samplen 2 spacing 1.2\n"
      "plot [0:1] [0:1] {}\n",
      kLegendTop, fmt::join(parts, ", \\\n     "));
}

}  // namespace

bool has_budget(const Json& summary_case) {
  const auto budget = summary_case.find("budget");
  return budget != summary_case.end() && !budget->empty();
}

std::string budget_script(const Json& summary_case, const std::string& file_stem) {
  const auto budgets = closure_budgets(summary_case);
  const auto names = part_names(budgets);
  const bool any_not_ok =
      std::ranges::any_of(budgets, [](const auto& budget) { return budget.status != "ok"; });
  std::string text =
      figure_output(file_stem, {.width = 1500, .height = 950}) + "# Columns: place, value, width\n";
  for (const auto& panel : kPanels) text += data(panel, budgets, names);
  text += fmt::format(
      "\nset grid ytics linetype 1 dashtype solid linecolor rgb '#DDDDDD' linewidth 0.6\n"
      "set tics nomirror\nset border 3\nset logscale y\nset format y '10^{{%L}}'\n"
      "set multiplot title {} font ',14'\n\n",
      figure_title(summary_case));
  for (const auto& panel : kPanels) text += axes(panel, budgets) + plot(panel, names);
  return text + legend(names, any_not_ok) + "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::compare
