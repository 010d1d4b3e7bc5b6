#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact/closed_forms.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/run_cases.hpp"
#include "paper_cases.hpp"
#include "rate_scan.hpp"
#include "thorough.hpp"

/// No solution of any method is `ok` without an error estimate.
namespace fpkcheck::methods {
namespace {

using transform::Solution;
using transform::SolutionRole;
using transform::Status;

Solution solution_without_estimate(const problem::Problem& problem) {
  const Method method = *builtin_registry().find_method_by_id("epc-polar-n4", {});
  const auto axes = compare::comparison_bins(problem);
  auto solution = solve_with_method(method, problem, {axes, {}});
  solution.error = {};
  return solution;
}

// A method that returns a good density with status `ok` and without an error estimate.
Method method_without_estimate(SolutionRole role, const std::string& id = "silent") {
  Method method{.identity = {.id = id,
                             .method = "probe",
                             .equation = problem::DensityEquation::kf,
                             .impact = problem::ImpactCondition::map,
                             .role = role},
                .solve = [](const problem::Problem& problem, const SolverInputContext&) {
                  return solution_without_estimate(problem);
                }};
  if (role == SolutionRole::external) {
    method.identity.equation = {};
    method.identity.impact = {};
  }
  return method;
}

TEST(ErrorEstimates, AreRequiredForOk) {
  for (const auto role :
       {SolutionRole::external, SolutionRole::equation, SolutionRole::simulation}) {
    const auto solutions =
        run_cases({tests::paper_case(1)}, {method_without_estimate(role)}, 1, {}).front().solutions;
    EXPECT_EQ(solutions.front().status, Status::inaccurate) << name(role);
    EXPECT_FALSE(solutions.front().reason.empty());
  }
}

TEST(ErrorEstimates, OfAClosureWithoutAReferenceAreResidualBased) {
  const auto solutions =
      run_cases({tests::paper_case(1)}, {method_without_estimate(SolutionRole::closure)}, 1, {})
          .front()
          .solutions;
  EXPECT_EQ(solutions.front().status, Status::ok) << solutions.front().reason;
  ASSERT_TRUE(solutions.front().error);
  // The error of epc-polar at n = 4 (docs/results.md).
  EXPECT_GT(solutions.front().error->y_l1, 8.6e-4);
  EXPECT_LT(solutions.front().error->y_l1, 2 * 8.6e-4);
}

TEST(ErrorEstimates, FollowFromTheReferenceIfMissing) {
  const auto solutions = run_cases({tests::paper_case(1)},
                                   {method_without_estimate(SolutionRole::external, "one"),
                                    method_without_estimate(SolutionRole::closure, "another"),
                                    *builtin_registry().find_method_by_id("fd-kf", {})},
                                   1, {})
                             .front()
                             .solutions;
  for (int k = 0; k < 2; ++k) {
    ASSERT_TRUE(solutions[k].error);
    EXPECT_EQ(solutions[k].status, Status::ok);
    // The error of epc-polar at n = 4 (docs/results.md).
    EXPECT_NEAR(solutions[k].error->y_l1, 8.6e-4, 2e-4);
    EXPECT_GE(solutions[k].error->moments.y2,
              std::abs(solutions[k].moments.y2 - solutions[2].moments.y2));
  }
}

TEST(ErrorEstimates, MustBeFinite) {
  Solution solution = solution_without_estimate(tests::paper_case(1));
  solution.error = transform::ErrorEstimate{.y_l1 = 1e-3, .ydot_l1 = 1e-3};
  transform::require_accuracy(1e-2, "it is off", solution);
  EXPECT_EQ(solution.status, Status::ok);
  solution.error->ydot_l1 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(transform::has_error_estimate(solution));
  transform::require_accuracy(1e-2, "it is off", solution);
  EXPECT_EQ(solution.status, Status::inaccurate);
}

// Where E[y'^2] is known exactly, checks the error estimate, which may be too low by the factor
// kLow.
void check(const problem::Problem& problem, const Solution& solution) {
  SCOPED_TRACE(problem.name + ", " + solution.id());
  if (!solution.has_status_ok()) {
    EXPECT_FALSE(solution.reason.empty());
    return;
  }
  EXPECT_TRUE(transform::has_error_estimate(solution));
  const bool exact = problem.system.restitution() == 1;
  if (!exact || !solution.error || solution.identity.role != SolutionRole::equation) return;
  constexpr double kLow = 2.5, kRounding = 1e-6;
  EXPECT_LE(std::abs(solution.moments.v2 - exact::mean_square_velocity(problem)),
            kLow * solution.error->moments.v2 + kRounding);
}

// At high rates cells are wider than impulses. Coarser grids then had no solution, and fd therefore
// no error estimate.
TEST(ErrorEstimates, ExistForEveryOkSolutionAtAnyRate) {
  tests::RateScan scan;
  if (!tests::is_thorough()) {
    scan.rates = {1e-4, 1e4, 1e5};
    scan.laws = {"gaussian", "exponential"};
    scan.restitutions = {1};
  }
  const auto registry = builtin_registry();
  auto methods =
      registry.methods_selected_by_list(tests::is_thorough() ? "epc,fd" : "fd-white,fd-kf", {});
  for (const auto& problem : scan.problems()) {
    for (const auto& one : run_cases({problem}, methods, 1, {})) {
      for (const auto& solution : one.solutions) check(problem, solution);
      // Frequent impulses must be solved as reliably as white noise.
      if (problem.impulses.arrival_rate() < 1e3) continue;
      EXPECT_TRUE(transform::find_solution(one.solutions, "fd-kf")->has_status_ok())
          << problem.name;
    }
  }
}

}  // namespace
}  // namespace fpkcheck::methods
