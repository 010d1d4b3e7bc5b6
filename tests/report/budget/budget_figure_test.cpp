#include "report/figure/case_figures.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "../budgeted_case.hpp"
#include "script_legend.hpp"

namespace fpkcheck::report {
namespace {

using tests::budgeted_case;
using tests::made_up_case;

FigureSeries series_of(const FigurePanel& panel, const std::string& name) {
  const auto found = std::ranges::find(panel.series, name, &FigureSeries::name);
  EXPECT_NE(found, panel.series.end()) << name;
  return found == panel.series.end() ? FigureSeries{} : *found;
}

// The series of a part in the figure of a budget that consists of this part.
FigureSeries series_of_part(const std::string& part) {
  auto case_result = budgeted_case();
  case_result.budget.resize(1);
  case_result.budget[0].parts.resize(1);
  case_result.budget[0].parts[0].approximations = compare::parse_approximations(part);
  return series_of(error_budget_figure(case_result).panels[0], part);
}

TEST(BudgetFigure, HasABarForEachPartAndALineForTheTotal) {
  const auto figure = error_budget_figure(budgeted_case());
  ASSERT_EQ(figure.panels.size(), 4u);
  const auto& panel = figure.panels[0];
  std::vector<std::string> names;
  for (const auto& series : panel.series) names.push_back(series.name);
  EXPECT_EQ(names, (std::vector<std::string>{"closure", "impact", "sampling", "total"}));
  // The three bars of the first group, and the two bars of the second, divide a width of 0.8.
  const auto closure = series_of(panel, "closure"), total = series_of(panel, "total");
  ASSERT_EQ(closure.points.size(), 2u);
  EXPECT_TRUE(closure.is_bars);
  EXPECT_NEAR(closure.points[0].x, 0.6 + 0.4 / 3, 1e-12);
  EXPECT_NEAR(closure.points[0].width, 0.8 / 3, 1e-12);
  EXPECT_NEAR(closure.points[1].width, 0.4, 1e-12);
  EXPECT_EQ(closure.points[0].y, 0.00231);
  EXPECT_NEAR(closure.points[0].upper, 0.00235, 1e-12);
  EXPECT_NEAR(closure.points[0].lower, 0.00227, 1e-12);
  EXPECT_EQ(closure.points[0].name, "epc-gaussian-n6, epc-gaussian-n6 → fd-km4-delta");
  EXPECT_NEAR(total.points[0].x, 0.6, 1e-12);
  EXPECT_NEAR(total.points[2].x, 1.4, 1e-12);
  EXPECT_EQ(total.points[0].y, 0.0024);
  EXPECT_EQ(total.dash, "solid");
  EXPECT_EQ(series_of(figure.panels[3], "sampling").points[0].y, 0.02);
}

TEST(BudgetFigure, HasThePlotsOfL1OnThePage) {
  const auto figure = error_budget_figure(budgeted_case());
  EXPECT_EQ(figure.panels[0].caption, "Error budget of p(y); *: not ok");
  EXPECT_EQ(figure.panels[2].caption, "Error budget of p(y′); *: not ok");
  const auto plots = make_page_plots(figure, "case-1");
  ASSERT_EQ(plots.size(), 2u);
  EXPECT_EQ(plots[1].id, "case-1-budget-ydot");
}

TEST(BudgetFigure, OmitsTheTailsInASingleColumn) {
  const auto figure = error_budget_figure(budgeted_case(), FigureWidth::one_column);
  ASSERT_EQ(figure.panels.size(), 2u);
  EXPECT_EQ(figure.panels[1].id, "budget-ydot");
}

TEST(BudgetFigure, AxisContainsEveryBar) {
  const Figure figure = error_budget_figure(budgeted_case());
  const auto& y = figure.panels[0].y;
  EXPECT_TRUE(y.is_logarithmic);
  EXPECT_LT(y.from, 0.00047);
  EXPECT_GT(y.to, 0.0024);
}

TEST(BudgetFigure, MarksClosuresThatAreNotOk) {
  const auto figure = error_budget_figure(budgeted_case());
  const auto& tics = figure.panels[0].x.tics;
  ASSERT_EQ(tics.size(), 2u);
  EXPECT_EQ(tics[0].label, "epc-gaussian-n6");
  EXPECT_EQ(tics[1].label, "epc-gaussian-n4 *");
  const auto closure = series_of(figure.panels[0], "closure");
  EXPECT_FALSE(closure.points[0].open);
  EXPECT_TRUE(closure.points[1].open);
}

TEST(BudgetFigure, DistinguishesAllParts) {
  std::set<std::string> colours{series_of_part("closure + impact").colour};
  for (const auto& link : compare::kApproximationNames) {
    EXPECT_TRUE(colours.insert(series_of_part(std::string(link.name)).colour).second) << link.name;
  }
  std::set<std::string> hatches;
  for (const char* part :
       {"impact", "white noise", "discretisation", "sampling", "closure + impact"}) {
    EXPECT_TRUE(hatches.insert(series_of_part(part).hatch).second) << part;
  }
  EXPECT_EQ(series_of_part("closure").hatch, "");
  EXPECT_EQ(series_of_part("impact + truncation").colour,
            series_of_part("closure + impact").colour);
}

TEST(BudgetFigure, HasALegendEntryForEachBar) {
  for (const auto width : {FigureWidth::screen, FigureWidth::one_column}) {
    for (const auto& case_result : {made_up_case(), budgeted_case()}) {
      const auto script =
          make_gnuplot_script(error_budget_figure(case_result, width), "stem", width);
      EXPECT_EQ(tests::elements_without_entry(script), std::vector<std::string>());
    }
  }
}

TEST(BudgetFigure, OmitsNonFiniteValues) {
  const auto figure = error_budget_figure(budgeted_case());
  EXPECT_TRUE(series_of(figure.panels[0], "impact").points.empty());
  EXPECT_TRUE(series_of(figure.panels[1], "impact").points.empty());
  auto case_result = budgeted_case();
  for (auto& row : case_result.budget) row.total = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(series_of(error_budget_figure(case_result).panels[0], "total").points.empty());
}

TEST(BudgetFigure, ShowsNamesLiterally) {
  auto case_result = budgeted_case();
  for (auto& row : case_result.budget) row.solution = "<b>_" + row.solution;
  const auto layout =
      tests::figure_of(make_page_plots(error_budget_figure(case_result), "case-1")[0]).at("layout");
  EXPECT_EQ(layout.at("yaxis").at("ticktext")[0], "&lt;b>_epc-gaussian-n6");
}

TEST(BudgetFigure, HasNoPanelsWithoutABudget) {
  auto case_result = made_up_case();
  EXPECT_EQ(error_budget_figure(case_result).panels.size(), 4u);
  case_result.budget.clear();
  EXPECT_TRUE(error_budget_figure(case_result).panels.empty());
}

}  // namespace
}  // namespace fpkcheck::report
