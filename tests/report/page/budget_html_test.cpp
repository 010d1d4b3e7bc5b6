#include "report/page/page_sections.hpp"

#include <gtest/gtest.h>

#include "../budgeted_case.hpp"
#include "made_up_page.hpp"

namespace fpkcheck::report {
namespace {

using tests::budgeted_case;

TEST(BudgetView, TablesHaveTheNumbersOfEveryPart) {
  const std::string html = error_budget_tables_html(budgeted_case());
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
  EXPECT_TRUE(tests::contains(error_budget_introduction_html(budgeted_case()),
                              "from a closure to mcs: L1"));
  auto case_result = budgeted_case();
  case_result.budget.clear();
  EXPECT_EQ(error_budget_introduction_html(case_result), "");
  EXPECT_EQ(error_budget_tables_html(case_result), "");
}

}  // namespace
}  // namespace fpkcheck::report
