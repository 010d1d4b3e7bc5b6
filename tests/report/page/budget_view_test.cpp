#include "report/page/budget_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "made_up_page.hpp"
#include "report/budget/part_style.hpp"

namespace fpkcheck::report {
namespace {

using compare::Approximation;

/// A case with the budgets of two closures in both marginals; the second closure is not ok.
results::CaseResult budgeted() {
  auto case_result = tests::whole_case();
  case_result.budget.clear();
  for (const auto variable : transform::kVariables) {
    compare::ErrorBudgetRow row{.solution = "epc-gaussian-n6",
                                .variable = variable,
                                .reference = "mcs",
                                .total = 0.0024,
                                .total_tail = 0.23,
                                .tail_from = 1e-5,
                                .tail_to = 1e-3,
                                .tail_bins = 17,
                                .parts = {}};
    row.parts = {{.approximations = {Approximation::closure},
                  .from = "epc-gaussian-n6",
                  .to = "fd-km4-delta",
                  .l1 = 0.00231,
                  .tail = 0.21,
                  .uncertainty = 0.00004},
                 {.approximations = {Approximation::impact},
                  .from = "fd-km4-delta",
                  .to = "fd-km4",
                  .l1 = std::numeric_limits<double>::quiet_NaN(),
                  .tail = std::numeric_limits<double>::quiet_NaN()},
                 {.approximations = {Approximation::sampling},
                  .from = "fd-kf limit",
                  .to = "mcs",
                  .l1 = 0.00047,
                  .tail = 0.02,
                  .expected = 0.00059,
                  .quantile_99 = 0.00081}};
    case_result.budget.push_back(row);
    row.solution = "epc-gaussian-n4";
    row.parts.erase(row.parts.begin() + 1);
    case_result.budget.push_back(row);
  }
  return case_result;
}

TEST(BudgetView, DrawsABarForEachPartThatIsKnown) {
  const auto plots = budget_plots(budgeted(), "case-1");
  ASSERT_EQ(plots.size(), 2u);
  EXPECT_EQ(plots[1].id, "case-1-budget-ydot");
  EXPECT_EQ(plots[1].caption, "Error budget of p(y\u2032); *: not ok");
  EXPECT_EQ(tests::names_in(plots[0]),
            (std::vector<std::string>{"closure", "impact", "sampling", "total"}));
  const auto closure = tests::trace_of(plots[0], "closure");
  EXPECT_EQ(closure.at("y"), nlohmann::json({"epc-gaussian-n6", "epc-gaussian-n4 *"}));
  EXPECT_EQ(closure.at("x"), nlohmann::json({0.00231, 0.00231}));
  EXPECT_EQ(closure.at("error_x").at("array")[0], 0.00004);
  EXPECT_EQ(closure.at("customdata")[0], "epc-gaussian-n6 \u2192 fd-km4-delta");
  EXPECT_EQ(closure.at("marker").at("color"), budget_part_colour("closure"));
  EXPECT_TRUE(tests::trace_of(plots[0], "impact").at("x").empty());
}

TEST(BudgetView, AxisContainsEveryBar) {
  const auto layout = tests::figure_of(budget_plots(budgeted(), "case-1")[0]).at("layout");
  EXPECT_LT(layout.at("xaxis").at("range")[0], std::log10(0.00047));
  EXPECT_GT(layout.at("xaxis").at("range")[1], std::log10(0.0024));
}

TEST(BudgetView, TablesHaveTheNumbersOfEveryPart) {
  const std::string html = budget_tables(budgeted());
  const std::string l1 = "Error budget of p(y): L1";
  EXPECT_EQ(tests::headers_in(html, l1),
            "solution|total|closure|sampling|L1 of sampling error alone: mean|L1 of sampling error "
            "alone: 99 % quantile");
  EXPECT_EQ(tests::row_in(html, l1, "epc-gaussian-n6"),
            "0.0024|0.0023 \u00b1 4.0e-5|0.00047|0.00059|0.00081");
  EXPECT_EQ(tests::row_in(html, "Error budget of the tail of p(y\u2032): mean |\u0394 log10 p|",
                          "epc-gaussian-n4 *"),
            "0.230|0.210|0.020");
}

TEST(BudgetView, NamesTheEndOfTheChain) {
  EXPECT_TRUE(tests::contains(budget_introduction(budgeted()), "from a closure to mcs: L1"));
  auto case_result = budgeted();
  case_result.budget.clear();
  EXPECT_EQ(budget_introduction(case_result), "");
  EXPECT_TRUE(budget_plots(case_result, "case-1").empty());
  EXPECT_EQ(budget_tables(case_result), "");
}

TEST(BudgetView, ShowsNamesLiterally) {
  auto case_result = budgeted();
  for (auto& row : case_result.budget) row.solution = "<b>" + row.solution;
  case_result.budget[0].parts[0].from = "a<b";
  const auto plots = budget_plots(case_result, "case-1");
  const auto closure = tests::trace_of(plots[0], "closure");
  EXPECT_EQ(closure.at("y")[0], "&lt;b>epc-gaussian-n6");
  EXPECT_EQ(closure.at("customdata")[0], "a&lt;b \u2192 fd-km4-delta");
  EXPECT_EQ(tests::figure_of(plots[0]).at("layout").at("yaxis").at("categoryarray")[0],
            "&lt;b>epc-gaussian-n6");
}

}  // namespace
}  // namespace fpkcheck::report
