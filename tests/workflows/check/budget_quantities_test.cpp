#include <gtest/gtest.h>

#include "solved_run.hpp"
#include "workflows/check/quantities.hpp"

namespace fpkcheck::check {
namespace {

using compare::ErrorBudgetRow;
using tests::moved_by;
using tests::scale;
using tests::solution;

/// The changes that follow from a change of the first row of the budget.
std::vector<QuantityChange> moved_by_row(const std::function<void(ErrorBudgetRow&)>& change) {
  return moved_by([&](results::Run& run) { change(run.cases[0].budget[0]); });
}

TEST(BudgetClaims, FindsAnotherBudget) {
  using Number = double& (*)(ErrorBudgetRow&);
  // Relative changes, so that small entries (3e-5) are found too.
  for (const Number number :
       {Number([](ErrorBudgetRow& row) -> double& { return row.total; }),
        Number([](ErrorBudgetRow& row) -> double& { return row.total_tail; }),
        Number([](ErrorBudgetRow& row) -> double& { return row.tail_from; }),
        Number([](ErrorBudgetRow& row) -> double& { return row.tail_to; }),
        Number([](ErrorBudgetRow& row) -> double& { return row.parts[0].l1; }),
        Number([](ErrorBudgetRow& row) -> double& { return row.parts[0].tail; }),
        Number([](ErrorBudgetRow& row) -> double& { return *row.parts[0].uncertainty; }),
        Number([](ErrorBudgetRow& row) -> double& { return row.parts[4].l1; }),
        Number([](ErrorBudgetRow& row) -> double& { return *row.parts[4].expected; }),
        Number([](ErrorBudgetRow& row) -> double& { return *row.parts[4].quantile_99; })}) {
    EXPECT_EQ(moved_by_row([&](ErrorBudgetRow& row) { scale(number(row), 0.01); }).size(), 1u);
  }
  EXPECT_EQ(moved_by_row([](ErrorBudgetRow& row) { ++row.tail_bins; }).size(), 1u);
}

TEST(BudgetClaims, ReportsAnotherChainOnce) {
  EXPECT_EQ(
      moved_by_row([](ErrorBudgetRow& row) { row.parts.erase(row.parts.begin() + 1); }).size(), 1u);
  EXPECT_EQ(moved_by_row([](ErrorBudgetRow& row) {
              row.parts[1].approximations = {compare::Approximation::white_noise};
            }).size(),
            1u);
  EXPECT_EQ(moved_by_row([](ErrorBudgetRow& row) { row.reference = "fd-kf"; }).size(), 1u);
}

TEST(BudgetClaims, ReportsARowThatOneRunLacks) {
  const auto found = moved_by([](results::Run& run) { run.cases[0].budget.pop_back(); });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, QuantityKind::budget);
  EXPECT_EQ(found[0].now, base::Value("missing"));
}

TEST(BudgetClaims, ABudgetToAnotherSimulationIsJudgedByItsSampling) {
  const auto by = [](const std::function<double&(ErrorBudgetRow&)>& number, double relative) {
    return moved_by([&](results::Run& run) {
             scale(solution(run, "mcs").moments.y2, 1e-6);  // another simulation
             scale(number(run.cases[0].budget[0]), relative);
           })
        .size();
  };
  const auto l1 = [](int part) {
    return [part](ErrorBudgetRow& row) -> double& { return row.parts[part].l1; };
  };
  const auto expected = [](ErrorBudgetRow& row) -> double& { return *row.parts[4].expected; };
  const auto tail = [](ErrorBudgetRow& row) -> double& { return row.parts[0].tail; };
  EXPECT_EQ(by(l1(4), 0.5), 0u);
  EXPECT_EQ(by(l1(4), 5), 1u);
  EXPECT_EQ(by(expected, 0.05), 0u);
  EXPECT_EQ(by(expected, 3), 1u);
  EXPECT_EQ(by(tail, 1), 0u);
  EXPECT_EQ(by(tail, 9), 1u);
  EXPECT_EQ(by(l1(0), 1e-5), 1u);  // deterministic
}

}  // namespace
}  // namespace fpkcheck::check
