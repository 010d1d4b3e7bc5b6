#include "report/figure/case_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "compare/error_budget.hpp"
#include "report/figure/figure_layout.hpp"
#include "report/figure/gnuplot.hpp"
#include "report/figure/script_text.hpp"

namespace fpkcheck::report {
namespace {

using compare::ClosureErrorBudget;
using compare::ErrorBudgetPart;
using compare::ErrorBudgetRow;
using transform::StateVariable;
using transform::Status;

// Width of the group of bars of a closure, relative to the distance between neighbouring groups of
// bars.
constexpr double kGroupWidth = 0.8;
// The axis excludes parts of the error budget below the fraction kSmallestFraction of the largest
// total distance, since small parts would compress all other bars.
constexpr double kSmallestFraction = 1e-4;

/// The kind of distance in a panel of the error budget: the L1 distance, or the mean logarithmic
/// ratio in the tail.
struct ErrorBudgetDistanceKind {
  const char* title;  ///< second part of the title of the panel
  const char* label;
  double ErrorBudgetRow::*total;
  double ErrorBudgetPart::*part;
};
constexpr ErrorBudgetDistanceKind kL1{"", "{/:Italic L}_1 distance", &ErrorBudgetRow::total,
                                      &ErrorBudgetPart::l1};
constexpr ErrorBudgetDistanceKind kTail{", tail: 10^{−5} ≤ {/:Italic p} < 10^{−3}",
                                        "mean |log_{10} ratio|", &ErrorBudgetRow::total_tail,
                                        &ErrorBudgetPart::tail};

// The colours of Okabe and Ito are distinct for colour-blind readers; hatching distinguishes
// colours that are equal in grey print.
struct ErrorBudgetBarStyle {
  compare::ModelApproximation approximation;
  const char* colour;
  const char* hatch;
};
constexpr ErrorBudgetBarStyle kBarStyles[] = {
    {compare::ModelApproximation::closure, "#D55E00", ""},
    {compare::ModelApproximation::impact, "#E69F00", "/"},
    {compare::ModelApproximation::truncation, "#0072B2", ""},
    {compare::ModelApproximation::white_noise, "#009E73", "|"},
    {compare::ModelApproximation::discretisation, "#56B4E9", "\\"},
    {compare::ModelApproximation::sampling, "#CC79A7", "x"}};
static_assert(std::size(kBarStyles) == std::size(compare::kApproximationNames));

// Returns the series of a part of the error budget in a figure, without points. A part of the error
// budget that combines the errors of several approximations is grey.
FigureSeries budget_part_series(const std::string& part) {
  FigureSeries series{
      .name = part, .group = "part " + part, .colour = "#999999", .is_bars = true, .hatch = "."};
  const auto approximations = compare::parse_approximations(part);
  if (approximations.size() > 1) return series;
  const auto* const style =
      std::ranges::find(kBarStyles, approximations.front(), &ErrorBudgetBarStyle::approximation);
  series.colour = style->colour;
  series.hatch = style->hatch;
  return series;
}

// Returns an axis of whole decades that contains all distances above kSmallestFraction times the
// largest distance.
FigureAxis budget_distance_axis(const char* label, const std::vector<FigureSeries>& all) {
  const auto [least, greatest] = coordinate_range(all, &FigurePoint::y);
  if (greatest < least) return {label, 1e-5, 1, true};
  const double from = std::max(least, kSmallestFraction * greatest);
  // The factors 0.8 and 1.2 leave space below the lowest bar and above the highest bar.
  return {label, std::pow(10, std::floor(std::log10(0.8 * from))),
          std::pow(10, std::ceil(std::log10(1.2 * greatest))), true};
}

FigureAxis closure_axis(const std::vector<ClosureErrorBudget>& budgets) {
  FigureAxis axis{.label = "",
                  .from = 0.4,
                  .to = static_cast<double>(budgets.size()) + 0.6,
                  .rotated_tics = true};
  for (const auto& budget : budgets) {
    axis.tics.push_back(
        {escape_enhanced_text(budget.solution) + (budget.status == Status::ok ? "" : " *"),
         static_cast<double>(axis.tics.size() + 1)});
  }
  return axis;
}

// Adds the bars of the error budget of one closure, side by side with equal widths, and a line at
// the total distance of the closure. Distances that are not positive are omitted, since the axis is
// logarithmic.
void add_closure_bars(std::vector<FigureSeries>& all, const ErrorBudgetRow& row, double centre,
                      bool is_open, const ErrorBudgetDistanceKind& distance) {
  const double width = kGroupWidth / static_cast<double>(row.parts.size());
  double left = centre - kGroupWidth / 2;
  for (const auto& part : row.parts) {
    const double value = part.*distance.part;
    if (value > 0) {
      FigurePoint bar{.x = left + width / 2,
                      .y = value,
                      .open = is_open,
                      .name = fmt::format("{}, {} → {}", row.solution, part.from, part.to),
                      .width = width};
      if (part.uncertainty && distance.part == kL1.part) {
        bar.lower = value - *part.uncertainty;
        bar.upper = value + *part.uncertainty;
      }
      std::ranges::find(all, part.error_budget_part_name(), &FigureSeries::name)
          ->points.push_back(bar);
    }
    left += width;
  }
  const double total = row.*distance.total;
  if (!(total > 0)) return;
  for (const double side : {-0.5, 0.0, 0.5}) {
    all.back().points.push_back(
        {.x = centre + side * kGroupWidth, .y = total, .name = row.solution + ", total"});
  }
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  all.back().points.push_back({.x = kGap, .y = kGap});
}

FigurePanel budget_panel(const std::vector<ClosureErrorBudget>& budgets, StateVariable variable,
                         const ErrorBudgetDistanceKind& distance) {
  FigurePanel panel{
      .title = std::string(base::meaning_of(variable)) +
               (distance.part == kL1.part ? ' ' + density_in_enhanced_text(variable) : "") +
               distance.title,
      .x = closure_axis(budgets),
      .y = {}};
  for (const auto& part : compare::budget_part_names(budgets)) {
    panel.series.push_back(budget_part_series(part));
  }
  panel.series.push_back({.name = "total",
                          .group = "part total",
                          .colour = "#000000",
                          .dash = "solid",
                          .line_width = 2.5});
  bool any_open = false;
  for (std::size_t k = 0; k < budgets.size(); ++k) {
    const bool is_open = budgets[k].status != Status::ok;
    any_open = any_open || is_open;
    if (const ErrorBudgetRow* row = budgets[k].budget_row_of(variable)) {
      add_closure_bars(panel.series, *row, static_cast<double>(k + 1), is_open, distance);
    }
  }
  panel.y = budget_distance_axis(distance.label, panel.series);
  if (distance.part == kL1.part) {
    panel.id = fmt::format("budget-{}", name(variable));
    panel.caption = fmt::format("Error budget of {}{}", density_in_plain_text(variable),
                                any_open ? "; *: not ok" : "");
  }
  return panel;
}

}  // namespace

Figure error_budget_figure(const results::CaseResult& case_result, FigureWidth width) {
  Figure figure{
      .title = problem_title_parts(case_result.problem), .screen_width = 1500, .panel_height = 280};
  const auto budgets = compare::group_budget_by_closure(case_result.budget, case_result.solutions);
  if (budgets.empty()) return figure;
  for (const StateVariable variable : transform::kVariables) {
    figure.panels.push_back(budget_panel(budgets, variable, kL1));
    // A figure for a single journal column is too narrow for the panels of tail distances.
    if (width == FigureWidth::one_column) continue;
    figure.panels.push_back(budget_panel(budgets, variable, kTail));
  }
  return figure;
}

}  // namespace fpkcheck::report
