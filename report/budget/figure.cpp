#include "report/budget/figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "report/budget/part_style.hpp"
#include "report/figure/layout.hpp"
#include "report/figure/script_text.hpp"

namespace fpkcheck::report {
namespace {

using compare::ClosureErrorBudget;
using compare::ErrorBudgetPart;
using compare::ErrorBudgetRow;
using transform::Status;
using transform::Variable;

// Width of a closure's group of bars, relative to the distance between neighbouring groups.
constexpr double kGroupWidth = 0.8;
// The axis range excludes parts of the error budget below this fraction of the largest total
// distance, since small parts would compress all other bars.
constexpr double kSmallestFraction = 1e-4;

/// A panel for one marginal density and one kind of distance: the L1 distance, or the mean
/// logarithmic ratio in the tail.
struct BudgetPanel {
  const char* title;
  const char* label;
  Variable variable;
  double ErrorBudgetRow::*total;
  double ErrorBudgetPart::*part;
  const char* block;  ///< prefix of the names of its data blocks
};
constexpr std::array kPanels{
    BudgetPanel{"displacement {/:Italic p}({/:Italic y})", "{/:Italic L}_1 distance", Variable::y,
                &ErrorBudgetRow::total, &ErrorBudgetPart::l1, "y_l1"},
    BudgetPanel{"displacement, tail: 10^{−5} ≤ {/:Italic p} < 10^{−3}", "mean |log_{10} ratio|",
                Variable::y, &ErrorBudgetRow::total_tail, &ErrorBudgetPart::tail, "y_tail"},
    BudgetPanel{"velocity {/:Italic p}({/:Italic y}')", "{/:Italic L}_1 distance", Variable::ydot,
                &ErrorBudgetRow::total, &ErrorBudgetPart::l1, "v_l1"},
    BudgetPanel{"velocity, tail: 10^{−5} ≤ {/:Italic p} < 10^{−3}", "mean |log_{10} ratio|",
                Variable::ydot, &ErrorBudgetRow::total_tail, &ErrorBudgetPart::tail, "v_tail"}};

std::string block(const BudgetPanel& panel, std::size_t part, bool ok) {
  return fmt::format("${}_{}{}", panel.block, part, ok ? "" : "_not_ok");
}

std::string totals_block(const BudgetPanel& panel) { return fmt::format("${}_total", panel.block); }

/// A bar of the figure: its position on the axis of closures (closure k is at k), its width and its
/// value.
struct BudgetBar {
  double centre, width, value;
};

// The bars of a closure by the names of their parts; all bars of a group have equal width.
std::vector<std::pair<std::string, BudgetBar>> bars(const BudgetPanel& panel,
                                                    const ClosureErrorBudget& budget,
                                                    std::size_t place) {
  std::vector<std::pair<std::string, BudgetBar>> result;
  const ErrorBudgetRow* row = budget.row(panel.variable);
  if (row == nullptr) return result;
  const double width = kGroupWidth / static_cast<double>(row->parts.size());
  double left = static_cast<double>(place) + 1 - kGroupWidth / 2;
  for (const auto& part : row->parts) {
    result.push_back({part.name(), {left + width / 2, width, part.*panel.part}});
    left += width;
  }
  return result;
}

std::string data(const BudgetPanel& panel, const std::vector<ClosureErrorBudget>& budgets,
                 const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t n = 0; n < names.size(); ++n) {
    for (const bool ok : {true, false}) {
      text += block(panel, n, ok) + " << EOD\n";
      for (std::size_t place = 0; place < budgets.size(); ++place) {
        if ((budgets[place].status == Status::ok) != ok) continue;
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
    const ErrorBudgetRow* row = budgets[place].row(panel.variable);
    if (row == nullptr || !(row->*panel.total > 0)) continue;
    text += fmt::format("{:.4f} {:.6g} {:.4f}\n", static_cast<double>(place) + 1 - kGroupWidth / 2,
                        row->*panel.total, kGroupWidth);
  }
  return text + "EOD\n";
}

/// The axis range in whole decades that contains all bars above kSmallestFraction of the largest
/// total.
struct DecadeRange {
  double from, to;
};
DecadeRange range(const BudgetPanel& panel, const std::vector<ClosureErrorBudget>& budgets) {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  const auto include = [&](double value) {
    if (!(value > 0)) return;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  };
  for (std::size_t place = 0; place < budgets.size(); ++place) {
    for (const auto& [name, bar] : bars(panel, budgets[place], place)) include(bar.value);
    const ErrorBudgetRow* row = budgets[place].row(panel.variable);
    if (row != nullptr) include(row->*panel.total);
  }
  if (greatest == 0) return {1e-5, 1};
  const double from = std::max(least, kSmallestFraction * greatest);
  // The factors 0.8 and 1.2 leave space below the lowest and above the highest bar.
  return {std::pow(10, std::floor(std::log10(0.8 * from))),
          std::pow(10, std::ceil(std::log10(1.2 * greatest)))};
}

// The id of a closure without the name of the method; an asterisk marks a closure that is not ok.
std::string tic_label(const results::CaseResult& case_result, const ClosureErrorBudget& budget) {
  std::string label = budget.solution;
  const auto* solution = case_result.find(label);
  if (solution != nullptr && label.starts_with(solution->identity.method + '-')) {
    label.erase(0, solution->identity.method.size() + 1);
  }
  return budget.status == Status::ok ? label : label + " *";
}

std::string axes(const BudgetPanel& panel, char letter,
                 const std::vector<ClosureErrorBudget>& budgets,
                 const results::CaseResult& case_result, const PanelBox& place_of_panel) {
  std::vector<std::string> tics;
  for (std::size_t place = 0; place < budgets.size(); ++place) {
    tics.push_back(
        fmt::format("{} {}", gnuplot_literal(tic_label(case_result, budgets[place])), place + 1));
  }
  const DecadeRange y = range(panel, budgets);
  return fmt::format(
      "set title {}\nset ylabel {}\n{}"
      "set xtics ({}) rotate by 35 right\n"
      "set xrange [0.4:{:.1f}]\nset yrange [{:g}:{:g}]\n",
      gnuplot_text(fmt::format("({}) {}", letter, panel.title)), gnuplot_text(panel.label),
      panel_position_commands(place_of_panel), fmt::join(tics, ", "),
      static_cast<double>(budgets.size()) + 0.6, y.from, y.to);
}

std::string plot(const BudgetPanel& panel, const std::vector<std::string>& names) {
  std::vector<std::string> plots;
  for (std::size_t n = 0; n < names.size(); ++n) {
    for (const bool ok : {true, false}) {
      plots.push_back(fmt::format("{} using 1:2:3 {} notitle", block(panel, n, ok),
                                  budget_part_bar_style(names[n], !ok)));
    }
  }
  plots.push_back(totals_block(panel) +
                  " using 1:2:3:(0) with vectors nohead linewidth 2.5 linecolor rgb '#000000' "
                  "notitle");
  return fmt::format("plot {}\n\n", fmt::join(plots, ", \\\n     "));
}

Legend legend(const std::vector<std::string>& names, bool any_not_ok) {
  Legend legend{{}, 2};
  for (const auto& name : names) {
    legend.entries.push_back({"NaN " + budget_part_bar_style(name, false), name});
  }
  legend.entries.push_back({"NaN with lines linewidth 2.5 linecolor rgb '#000000'", "total"});
  if (any_not_ok) {
    legend.entries.push_back(
        {"NaN with boxes fillstyle solid 0.3 linecolor rgb '#000000'", "* not ok"});
  }
  return legend;
}

}  // namespace

bool has_budget(const results::CaseResult& case_result) { return !case_result.budget.empty(); }

std::string budget_script(const results::CaseResult& case_result, const std::string& file_stem,
                          FigureWidth width) {
  constexpr int kOnScreen = 1500, kRotatedTics = 120;
  const auto budgets = compare::closure_error_budgets(case_result.budget, case_result.solutions);
  const auto names = compare::budget_part_names(budgets);
  const bool any_not_ok =
      std::ranges::any_of(budgets, [](const auto& budget) { return budget.status != Status::ok; });
  const Legend entries = legend(names, any_not_ok);
  PanelGrid grid = panel_grid(width, kOnScreen);
  // A figure for a single journal column is too narrow for the panels of the tail distances.
  const bool narrow = width == FigureWidth::one_column;
  grid.columns = narrow ? 1 : 2;
  grid.rows = 2;
  grid.panel_height = width == FigureWidth::screen ? 280 : 180;
  grid.below = kRotatedTics;
  grid.legend_height = legend_height(entries, grid.width);
  const FigureTitle title = figure_title(case_result.problem, grid.size());
  grid.title_height = title.height;
  std::string text =
      gnuplot_output_commands(file_stem, grid.size()) + "# Columns: place, value, width\n";
  for (const auto& panel : kPanels) text += data(panel, budgets, names);
  text += fmt::format(
      "\nset grid ytics linetype 1 dashtype solid linecolor rgb '#DDDDDD' linewidth 0.6\n"
      "set tics nomirror\nset border 3\nset logscale y\nset format y {}\n{}{}",
      kPowerOfTenFormat, PanelGrid::kLabels, title.command);
  for (std::size_t k = 0; k < kPanels.size(); ++k) {
    if (narrow && k % 2 == 1) continue;
    const std::size_t place = narrow ? k / 2 : k;
    text += axes(kPanels[k], static_cast<char>('a' + place), budgets, case_result,
                 grid.panel_box(place)) +
            plot(kPanels[k], names);
  }
  return text + legend_strip_commands(entries, grid.size()) + "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::report
