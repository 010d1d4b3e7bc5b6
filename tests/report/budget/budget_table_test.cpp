#include "report/terminal_tables.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "modified_case.hpp"
#include "results/run.hpp"
#include "saved_run.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;
using tests::made_up_case;

std::vector<std::string> cells_after(const std::string& text, const std::string& start) {
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(start)) continue;
    std::istringstream row(line);
    std::vector<std::string> cells;
    for (std::string cell; row >> cell;) cells.push_back(cell);
    return cells;
  }
  return {};
}

results::CaseResult with_known_numbers() {
  auto case_result = made_up_case();
  auto& row = case_result.budget[5];
  EXPECT_EQ(row.solution, "epc-gaussian-n6");
  EXPECT_EQ(row.variable, transform::StateVariable::ydot);
  row.total = 0.01111;
  row.total_tail = 0.2222;
  row.parts[0].l1 = 0.03333;
  row.parts[1].l1 = 4.4e-6;
  case_result.update_assessment();
  return case_result;
}

TEST(BudgetTable, HasTheNumbersAndTheSentenceThatWereSaved) {
  const auto case_result = with_known_numbers();
  const std::string text = error_budget_table_text(case_result, 120);
  // Columns: names; total, closure + impact, truncation of p(y), then of p(y'); the tails.
  const auto n6 = cells_after(text, "epc-gaussian-n6");
  ASSERT_EQ(n6.size(), 9u) << text;
  EXPECT_EQ((std::vector<std::string>{n6[4], n6[5], n6[6], n6[8]}),
            (std::vector<std::string>{"0.01111", "0.03333", "4.4e-06", "0.222"}));
  const std::string limits = results::limiting_errors_text(case_result);
  EXPECT_TRUE(tests::collapse_whitespace(text).ends_with(" " + limits + " ")) << text;
}

TEST(BudgetTable, MarksClosuresThatAreNotOkAndPutsCommonPartsBelow) {
  auto case_result = with_known_numbers();
  case_result.budget[0].parts.back().l1 = 0.00777;
  const std::string text = error_budget_table_text(case_result, 120);
  EXPECT_EQ(cells_after(text, "epc-gaussian-n4")[0], "epc-gaussian-n4*");
  const auto below = cells_after(text, "discretisation + sampling");
  ASSERT_GT(below.size(), 4u) << text;
  EXPECT_EQ(below[3], "0.00777") << text;
  EXPECT_EQ(below[4], "-") << text;  // the row has no value in the column of a part
}

TEST(BudgetTable, ShowsADashForMissingValues) {
  auto case_result = with_known_numbers();
  case_result.budget[5].total_tail = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(cells_after(error_budget_table_text(case_result, 120), "epc-gaussian-n6")[8], "-");
  case_result.budget.erase(case_result.budget.begin() + 5);
  const auto n6 = cells_after(error_budget_table_text(case_result, 120), "epc-gaussian-n6");
  EXPECT_EQ((std::vector<std::string>{n6[4], n6[5], n6[6], n6[8]}),
            (std::vector<std::string>{"-", "-", "-", "-"}));
}

TEST(BudgetTable, HasOnlyTotalsAtSmallWidth) {
  const std::string text = error_budget_table_text(with_known_numbers(), 60);
  EXPECT_FALSE(contains(text, "tail"));
  EXPECT_FALSE(contains(text, "trunc."));
  EXPECT_EQ(cells_after(text, "epc-gaussian-n6").back(), "0.01111") << text;
}

TEST(BudgetTable, IsEmptyWithoutABudget) {
  auto case_result = made_up_case();
  case_result.budget.clear();
  EXPECT_EQ(error_budget_table_text(case_result, 100), "");
  EXPECT_TRUE(displayed_budget_columns(case_result, 100).empty());
}

}  // namespace
}  // namespace fpkcheck::report
