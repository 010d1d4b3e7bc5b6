#include "workflows/paper/closure_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "judged_run.hpp"
#include "workflows/paper/criteria.hpp"

namespace fpkcheck::paper {
namespace {

using tests::budget_row;
using tests::case_in;
using tests::run_with_distances;
using transform::Variable;

TEST(DistanceToTheSimulation, ComesFromTheErrorBudget) {
  auto run = run_with_distances();
  auto& row = budget_row(run, 2, 6, Variable::ydot);
  row.total = 0.013;
  row.total_tail = 0.17;
  row.parts.back().approximations = {compare::Approximation::discretisation};
  row.parts.back().tail = 0.004;
  std::string missing;
  const auto distance = distance_to_simulation(case_in(run, 2), 6, Variable::ydot, missing);
  ASSERT_TRUE(distance) << missing;
  EXPECT_EQ(distance->l1, 0.013);
  EXPECT_EQ(distance->tail, 0.17);
  EXPECT_EQ(distance->tail_error, 0.004);
  EXPECT_EQ(distance->l1_error, 0.0015);  // stated by the simulation
}

TEST(DistanceToTheSimulation, IsInfiniteInTheTailWhereAClosureIsZeroInPartOfIt) {
  auto run = run_with_distances();
  budget_row(run, 1, 4, Variable::y).tail_bins = 8;
  std::string missing;
  EXPECT_TRUE(std::isinf(distance_to_simulation(case_in(run, 1), 4, Variable::y, missing)->tail));
  EXPECT_EQ(distance_to_simulation(case_in(run, 1), 6, Variable::y, missing)->tail, 0.1);
}

TEST(DistanceToTheSimulation, IsEmptyWithoutADensityOrAnAccurateReference) {
  auto run = run_with_distances();
  std::string missing;
  EXPECT_FALSE(distance_to_simulation(case_in(run, 1), 8, Variable::y, missing));
  EXPECT_EQ(missing, "case1 has no density of epc-gaussian-n8");

  case_in(run, 1).solutions.back().sampling = {.y = 0.011, .ydot = 0.011};
  EXPECT_FALSE(distance_to_simulation(case_in(run, 1), 6, Variable::y, missing));
  EXPECT_EQ(missing, "the reference of case1 has an error of up to L1 0.011: simulate longer");

  case_in(run, 2).budget.clear();
  EXPECT_FALSE(distance_to_simulation(case_in(run, 2), 6, Variable::y, missing));
  EXPECT_EQ(missing, "case2 has no reference solution");

  budget_row(run, 3, 6, Variable::y).total = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(distance_to_simulation(case_in(run, 3), 6, Variable::y, missing));
  EXPECT_EQ(missing, "the distance of epc-gaussian-n6 in case3 is not a number");
}

TEST(DistanceToTheSimulation, MaximumIsTakenOfEachNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Distance both =
      larger_distances({.l1 = 1, .tail = 4}, {.l1 = 2, .tail = 3, .l1_error = 0.1});
  EXPECT_EQ(both.l1, 2);
  EXPECT_EQ(both.tail, 4);
  EXPECT_EQ(both.l1_error, 0.1);
  EXPECT_TRUE(std::isnan(larger_distances({.tail = nan}, {.tail = 1}).tail));
  EXPECT_TRUE(std::isnan(larger_distances({.tail = 1}, {.tail = nan}).tail));
}

}  // namespace
}  // namespace fpkcheck::paper
