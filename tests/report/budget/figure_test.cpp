#include "report/budget/figure.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "modified_case.hpp"
#include "report/budget/part_style.hpp"
#include "saved_run.hpp"
#include "script_legend.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;
using tests::made_up_case;

TEST(BudgetFigure, HasABarForEachPartAndALineForTheTotal) {
  auto case_result = made_up_case();
  case_result.budget[0].parts[0].l1 = 0.04321;
  case_result.budget[0].total = 0.01234;
  const std::string script = budget_script(case_result, "stem");
  // epc-gaussian-n2 has the first group; its bars divide a width of 0.8.
  EXPECT_TRUE(contains(script, "$y_l1_0 << EOD\n0.7333 0.04321 0.2667\n")) << script;
  EXPECT_TRUE(contains(script, "$y_l1_total << EOD\n0.6000 0.01234 0.8000\n")) << script;
  EXPECT_TRUE(contains(script, budget_part_colour("closure + impact")));
}

TEST(BudgetFigure, DrawsClosuresThatAreNotOkPaleAndMarked) {
  auto case_result = made_up_case();
  EXPECT_TRUE(contains(budget_script(case_result, "stem"), "'gaussian-n4 *' 2"));
  EXPECT_TRUE(contains(budget_script(case_result, "stem"), "* not ok"));
  tests::solution_of(case_result, "epc-gaussian-n4").status = transform::Status::ok;
  case_result.assess();
  EXPECT_FALSE(contains(budget_script(case_result, "stem"), "*'"));
}

TEST(BudgetFigure, HasALegendEntryForEachBar) {
  for (const auto width : {FigureWidth::screen, FigureWidth::one_column}) {
    const auto untold = tests::elements_without_entry(budget_script(made_up_case(), "stem", width));
    EXPECT_TRUE(untold.empty()) << untold.front();
  }
}

TEST(BudgetFigure, OmitsNonFiniteValues) {
  auto case_result = made_up_case();
  for (auto& row : case_result.budget) {
    row.total_tail = std::numeric_limits<double>::quiet_NaN();
    for (auto& part : row.parts) part.tail = std::numeric_limits<double>::quiet_NaN();
  }
  const std::string script = budget_script(case_result, "stem");
  EXPECT_TRUE(contains(script, "$y_tail_0 << EOD\nEOD\n")) << script;
  EXPECT_TRUE(contains(script, "$y_tail_total << EOD\nEOD\n")) << script;
  EXPECT_FALSE(contains(script, "nan"));
}

TEST(BudgetFigure, ExistsWithABudget) {
  auto case_result = made_up_case();
  EXPECT_TRUE(has_budget(case_result));
  case_result.budget.clear();
  EXPECT_FALSE(has_budget(case_result));
}

}  // namespace
}  // namespace fpkcheck::report
