
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "modified_case.hpp"
#include "report/terminal_tables.hpp"
#include "saved_run.hpp"

namespace fpkcheck::report {
namespace {

using tests::collapse_whitespace;
using tests::contains;
using tests::made_up_case;

std::string legend_of(const results::CaseResult& case_result, std::size_t width) {
  const std::string text =
      terminal_tables_text({results::current_program(""), {case_result}}, width);
  return collapse_whitespace(text.substr(text.find("\n\n")));
}

// The legend explains every name of an equation or impact in the table.
TEST(Legend, ExplainsEveryEquationAndImpact) {
  auto case_result = made_up_case();
  for (const auto& equation : problem::kEquationNames) {
    for (const auto& impact : problem::kImpactNames) {
      for (auto& solution : case_result.solutions) {
        solution.identity.equation = equation.value;
        solution.identity.impact = impact.value;
      }
      EXPECT_TRUE(
          contains(legend_of(case_result, 100),
                   fmt::format("solves: the excitation term ({}: {}) / the impact ({}: {}).",
                               equation.name, equation.meaning, impact.name, impact.meaning)))
          << legend_of(case_result, 100);
    }
  }
  case_result.solutions[0].identity.equation.reset();
  case_result.solutions[0].identity.impact.reset();
  EXPECT_TRUE(contains(legend_of(case_result, 100), " / given: an external density."));
}

TEST(Legend, ExplainsTheColumnsThatAreShownAndNoOther) {
  const std::string wide = legend_of(made_up_case(), 140), narrow = legend_of(made_up_case(), 80);
  for (const char* part :
       {"L1: integral", "white: white noise", "energy: residual", "sec: wall-clock",
        "its parts and of the row discretisation + sampling;",
        "closure: the closure approximation, against", "impact: the impact to first order",
        "trunc.: the truncation of the Kramers-Moyal series", "tail: mean",
        "*: the closure is not ok"}) {
    EXPECT_TRUE(contains(wide, part)) << part << "\n" << wide;
  }
  EXPECT_FALSE(contains(narrow, "energy: residual")) << narrow;
  EXPECT_FALSE(contains(narrow, "tail: mean")) << narrow;

  const std::string single = legend_of(tests::case_with_first(1), 100);
  EXPECT_TRUE(contains(single, "km4: Kramers-Moyal")) << single;
  for (const char* absent : {"L1", "- reference|", "error budget", "white noise", "kf:", "*"}) {
    EXPECT_FALSE(contains(single, absent)) << absent << "\n" << single;
  }
}

TEST(Legend, OfABudgetExplainsEveryLinkOfTheChain) {
  TextTableColumn names{"", "error budget", true, kAlwaysShown, {"toy"}};
  for (const auto& [link, name, meaning] : compare::kApproximationNames) {
    const TextTableColumn part{
        "L1 of p(y)", error_budget_part_header(std::string(name)), false, 1, {"0.1"}};
    const std::string text = error_budget_table_legend({names, part});
    EXPECT_TRUE(contains(text, fmt::format("; {}: {}", part.header, meaning))) << text;
  }
  // Each of several approximations that share a column.
  const TextTableColumn shared{"L1 of p(y)", "closure + truncation", false, 1, {"0.1"}};
  const std::string text = error_budget_table_legend({names, shared});
  EXPECT_TRUE(contains(text, "; closure: ") && contains(text, "; trunc.: ")) << text;
  EXPECT_EQ(error_budget_table_legend({}), "");
}

}  // namespace
}  // namespace fpkcheck::report
