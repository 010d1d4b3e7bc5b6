#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "judged_run.hpp"
#include "made_up_solutions.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "workflows/paper/claim_criteria.hpp"
#include "workflows/paper/closure_distances.hpp"

namespace fpkcheck::paper {
namespace {

using tests::budget_row;
using tests::case_in;
using tests::run_with_distances;
using transform::StateVariable;

TEST(DistanceToTheSimulation, ComesFromTheErrorBudget) {
  auto run = run_with_distances();
  auto& row = budget_row(run, 2, 6, StateVariable::ydot);
  row.total = 0.013;
  row.total_tail = 0.17;
  row.parts.back().approximations = {compare::ModelApproximation::discretisation};
  row.parts.back().tail = 0.004;
  std::string missing;
  const auto distance =
      closure_distance_to_simulation(case_in(run, 2), 6, StateVariable::ydot, missing);
  ASSERT_TRUE(distance) << missing;
  EXPECT_EQ(distance->l1, 0.013);
  EXPECT_EQ(distance->tail, 0.17);
  EXPECT_EQ(distance->tail_error, 0.004);
  EXPECT_EQ(distance->l1_error, 0.0015);  // stated by the simulation
}

TEST(DistanceToTheSimulation, IsInfiniteInTheTailWhereAClosureIsZeroInPartOfIt) {
  auto run = run_with_distances();
  budget_row(run, 1, 4, StateVariable::y).tail_bins = 8;
  std::string missing;
  EXPECT_TRUE(std::isinf(
      closure_distance_to_simulation(case_in(run, 1), 4, StateVariable::y, missing)->tail));
  EXPECT_EQ(closure_distance_to_simulation(case_in(run, 1), 6, StateVariable::y, missing)->tail,
            0.1);
}

TEST(DistanceToTheSimulation, IsEmptyWithoutADensityOrAnAccurateReference) {
  auto run = run_with_distances();
  std::string missing;
  EXPECT_FALSE(closure_distance_to_simulation(case_in(run, 1), 8, StateVariable::y, missing));
  EXPECT_EQ(missing, "case1 has no density of epc-gaussian-n8");

  case_in(run, 1).solutions.back().sampling = {.y = 0.011, .ydot = 0.011};
  case_in(run, 1).update_assessment();
  EXPECT_FALSE(closure_distance_to_simulation(case_in(run, 1), 6, StateVariable::y, missing));
  EXPECT_EQ(missing, "the reference of case1 has an error of up to L1 0.011: simulate longer");

  case_in(run, 2).budget.clear();
  EXPECT_FALSE(closure_distance_to_simulation(case_in(run, 2), 6, StateVariable::y, missing));
  EXPECT_EQ(missing, "case2 has no reference solution");

  budget_row(run, 3, 6, StateVariable::y).total = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(closure_distance_to_simulation(case_in(run, 3), 6, StateVariable::y, missing));
  EXPECT_EQ(missing, "the distance of epc-gaussian-n6 in case3 is not a number");
}

TEST(DistanceToTheSimulation, MaximumIsTakenOfEachNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ClosureDistanceFromSimulation both =
      componentwise_maximum({.l1 = 1, .tail = 4}, {.l1 = 2, .tail = 3, .l1_error = 0.1});
  EXPECT_EQ(both.l1, 2);
  EXPECT_EQ(both.tail, 4);
  EXPECT_EQ(both.l1_error, 0.1);
  EXPECT_TRUE(std::isnan(componentwise_maximum({.tail = nan}, {.tail = 1}).tail));
  EXPECT_TRUE(std::isnan(componentwise_maximum({.tail = 1}, {.tail = nan}).tail));
}

using transform::StateVariable;

// Bin averages of a Gaussian: its deviation is that of equivalent linearisation times a factor.
results::DensityCurve gaussian_curve(const problem::Problem& problem, StateVariable variable,
                                     double factor) {
  const auto linear = problem::equivalent_linearisation(problem);
  const bool is_y = variable == StateVariable::y;
  const double sigma = factor * (is_y ? linear.displacement_deviation : linear.velocity_deviation);
  const auto axes = compare::comparison_bins(problem);
  const auto& edges = compare::comparison_bin_edges(axes, variable);
  results::DensityCurve curve{.solution = "epc-gaussian-n2",
                              .variable = variable,
                              .abscissa = {},
                              .density = {},
                              .lower = {},
                              .upper = {}};
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    const double from = edges[k], to = edges[k + 1];
    const auto below = [&](double x) { return std::erf(x / (std::numbers::sqrt2 * sigma)); };
    curve.abscissa.push_back((from + to) / 2);
    curve.density.push_back((is_y ? 1.0 : 0.5) * (below(to) - below(from)) / (to - from));
  }
  return curve;
}

TEST(Linearisation, DistanceToTheSameGaussianIsZero) {
  const auto problem = tests::paper_case(4);
  for (const auto variable : transform::kVariables) {
    EXPECT_LT(l1_to_equivalent_linearisation(gaussian_curve(problem, variable, 1), problem), 1e-12);
  }
}

TEST(Linearisation, DistanceToAnotherDeviationIsThatOfTwoGaussians) {
  const auto problem = tests::paper_case(1);
  // The densities cross at x^2 = 2 ln s / (1 - 1/s^2) deviations squared.
  const double s = 1.1, x = std::sqrt(2 * std::log(s) / (1 - 1 / (s * s)));
  const double l1 =
      2 * (std::erf(x / std::numbers::sqrt2) - std::erf(x / (s * std::numbers::sqrt2)));
  for (const auto variable : transform::kVariables) {
    // Up to the bins in which they cross.
    EXPECT_NEAR(l1_to_equivalent_linearisation(gaussian_curve(problem, variable, s), problem), l1,
                0.01 * l1);
  }
}

}  // namespace
}  // namespace fpkcheck::paper
