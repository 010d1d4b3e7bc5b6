#include <gtest/gtest.h>

#include "methods/builtin_solvers.hpp"
#include "methods/run_cases.hpp"
#include "paper_cases.hpp"

/// The error budget (compare/error_budget.hpp) of solutions from the actual solvers.
namespace fpkcheck::methods {
namespace {

void expect_the_parts_bound_the_total(const std::vector<compare::ErrorBudgetRow>& budget) {
  constexpr double kRounding = 1e-12;
  for (const auto& row : budget) {
    double l1 = 0, tail = 0;
    for (const auto& part : row.parts) {
      l1 += part.l1;
      tail += part.tail;
    }
    EXPECT_LE(row.total, l1 * (1 + kRounding)) << row.solution;
    ASSERT_GT(row.tail_bins, 0) << row.solution;
    EXPECT_LE(row.total_tail, tail * (1 + kRounding)) << row.solution;
  }
}

// Solved once for all tests of a process.
const std::vector<transform::Solution>& without_simulation() {
  static const auto solutions =
      run_cases({tests::paper_case(1)},
                builtin_registry().methods_selected_by_list(
                    "epc-gaussian-n2,epc-gaussian-n4,epc-gaussian-n6,epc-moment-n8,fd", {}),
                0, {})
          .front()
          .solutions;
  return solutions;
}

results::CaseResult case_1(bool controlled) {
  const auto problem = tests::paper_case(1);
  const auto axes = compare::comparison_bins(problem);
  const auto simulation = builtin_registry()
                              .methods_selected_by_list("mcs", {{"time", controlled ? 3e6 : 2e5},
                                                                {"controlled", controlled}})
                              .front();
  auto solutions = without_simulation();
  solutions.push_back(solve_with_method(simulation, problem, {axes, {}}));
  return results::make_case_result(problem, axes, std::move(solutions));
}

// A simulation with control variates has an L1 error of about 2e-6. Hence the budget has no
// sampling part, and the simulation measures the discretisation.
TEST(BudgetOfARun, EndsWithTheMeasuredDiscretisation) {
  const auto one = case_1(true);
  ASSERT_EQ(one.budget.size(), 8u);
  expect_the_parts_bound_the_total(one.budget);
  for (const auto& row : one.budget) {
    EXPECT_EQ(row.parts.size(), row.solution == "epc-moment-n8" ? 2u : 4u) << row.solution;
    EXPECT_EQ(row.reference, "mcs");
    const auto& last = row.parts.back();
    EXPECT_EQ(last.error_budget_part_name(), "discretisation");
    EXPECT_EQ(last.from, "fd-kf");
    EXPECT_LT(*last.standard_error, 0.1 * last.l1);
    // The error estimate of fd-kf, from the same grids and without simulation.
    const double stated = transform::l1_error_of_marginal(*one.find("fd-kf")->error, row.variable);
    EXPECT_NEAR(last.l1, stated, 0.15 * stated);
  }
}

TEST(BudgetOfARun, IsBoundedByItsPartsInEveryRow) {
  const auto one = case_1(false);
  const auto& budget = one.budget;
  ASSERT_EQ(budget.size(), 8u);
  expect_the_parts_bound_the_total(budget);
  for (const auto& row : budget) {
    const bool moment = row.solution == "epc-moment-n8";
    EXPECT_EQ(row.parts.size(), moment ? 3u : 5u) << row.solution;
    for (const auto& part : row.parts) {
      if (part.error_budget_part_name() == "sampling") {
        EXPECT_LT(part.l1, 1.5 * part.quantile_99.value());
      } else if (part.error_budget_part_name() != "discretisation") {
        EXPECT_GT(part.l1, part.uncertainty.value())
            << row.solution << " " << part.error_budget_part_name();
      }
    }
  }
  // docs/budget.md: the closure limits equivalent linearisation, not its equation.
  EXPECT_GT(budget[1].parts[0].l1, 20 * budget[1].parts[1].l1);
}

}  // namespace
}  // namespace fpkcheck::methods
