#include "methods/residual_error_estimator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

#include "exact/energy_law.hpp"
#include "general_oscillators.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/run_cases.hpp"
#include "paper_cases.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::methods {
namespace {

using transform::Solution;
using transform::StateVariable;
using transform::Status;

Solution solved(const std::string& id, const base::Values& given = {}) {
  const auto p = tests::paper_case(1);
  const auto axes = compare::comparison_bins(p);
  return solve_with_method(*builtin_registry().find_method_by_id(id, given), p, {axes, {}});
}

TEST(ResidualErrorEstimate, AgreesWithTheDistanceFromTheJumpEquation) {
  const auto p = tests::paper_case(1);
  const auto axes = compare::comparison_bins(p);
  const auto reference = solved("fd-kf");
  // The errors are between 0.25 and 0.01 per cent and include the error of the model.
  for (const char* id : {"epc-gaussian-n2", "epc-gaussian-n4", "epc-moment-n4", "epc-moment-n8",
                         "epc-moment-white-n8", "epc-polar-n4"}) {
    const auto closure = solved(id);
    ASSERT_TRUE(closure.error) << id;
    for (const auto variable : transform::kVariables) {
      const auto& edges = compare::comparison_bin_edges(axes, variable);
      const double apart = transform::l1_distance(transform::marginal(closure, variable, edges),
                                                  transform::marginal(reference, variable, edges));
      EXPECT_NEAR(transform::l1_error_of_marginal(*closure.error, variable) / apart, 1.6, 0.3)
          << id << apart;
    }
  }
}

TEST(ResidualErrorEstimate, DeterminesTheStatusOfAClosure) {
  const auto linearised = solved("epc-gaussian-n2");
  EXPECT_EQ(linearised.status, Status::inaccurate);
  EXPECT_NE(linearised.reason.find("0.043 in p(y')"), std::string::npos) << linearised.reason;
  EXPECT_TRUE(linearised.density);
  EXPECT_EQ(solved("epc-gaussian-n2", {{"accuracy", 0.05}}).status, Status::ok);
  EXPECT_EQ(solved("epc-moment-n8").status, Status::ok);
  EXPECT_EQ(solved("epc-moment-n8", {{"accuracy", 1e-4}}).status, Status::inaccurate);
}

TEST(ResidualErrorEstimate, KeepsOtherStatuses) {
  Solution solution;
  solution.status = Status::inadmissible;
  solution.reason = "no density";
  solution.density = transform::SmoothDensity{
      [](double y, double v) { return std::exp(-(y * y + v * v)) * 2 / std::numbers::pi; }, 6, 6};
  const ResidualErrorEstimator residuals(tests::paper_case(1));
  set_residual_error_estimate(residuals, 1e-3, solution);
  EXPECT_EQ(solution.status, Status::inadmissible);
  EXPECT_EQ(solution.reason, "no density");
  EXPECT_TRUE(solution.error);
  solution.status = Status::ok;
  set_residual_error_estimate(residuals, 1e-3, solution);
  EXPECT_EQ(solution.status, Status::inaccurate);

  Solution without;
  without.status = Status::not_converged;
  set_residual_error_estimate(residuals, 1e-3, without);
  EXPECT_FALSE(without.error);
}

TEST(ResidualErrorEstimate, IsUnknownWithoutAMean) {
  Solution solution;
  solution.status = Status::ok;
  solution.density = transform::SmoothDensity{[](double, double) { return 0.0; }, 6, 6};
  set_residual_error_estimate(ResidualErrorEstimator(tests::paper_case(1)), 1e-3, solution);
  EXPECT_EQ(solution.status, Status::inaccurate);
  EXPECT_NE(solution.reason.find("cannot be estimated"), std::string::npos);
}

TEST(ResidualErrorEstimate, IsTheSameInPhysicalAndWallCoordinates) {
  // A single wall, at the right. The exact density of weaker noise has a known error.
  const problem::System system({.damping = 0.2, .stiffness = 1},
                               {.right = 0.5, .right_restitution = 1});
  const auto known = tests::with_noise(system, 0.4), weaker = tests::with_noise(system, 0.36);
  const exact::EnergyLaw law(weaker);
  Solution solution;
  solution.status = Status::ok;
  solution.density = transform::SmoothDensity{law, 0.5, 6, -6};
  const ResidualErrorEstimator residuals(known);
  EXPECT_EQ(residuals.unsupported_reason(), "");
  set_residual_error_estimate(residuals, 0.1, solution);
  ASSERT_TRUE(solution.error);
  EXPECT_EQ(solution.status, Status::ok) << solution.reason;
  const double y1 = law.moment(1, 0) - exact::EnergyLaw(known).moment(1, 0);
  EXPECT_NEAR(solution.error->moments.y1, std::abs(y1), 1e-3 * std::abs(y1));
  EXPECT_GT(solution.error->ydot_l1, 0.05);  // about 1 - sqrt(0.9), as for a Gaussian
  EXPECT_LT(solution.error->ydot_l1, 0.1);

  const auto seen = tests::in_wall_coordinates(known);
  Solution in_wall_coordinates = solution;
  in_wall_coordinates.density = transform::to_wall_coordinates(seen.frame, *solution.density);
  set_residual_error_estimate(ResidualErrorEstimator(seen), 0.1, in_wall_coordinates, seen.frame);
  ASSERT_TRUE(in_wall_coordinates.error);
  EXPECT_NEAR(in_wall_coordinates.error->y_l1, solution.error->y_l1, 1e-12);
  EXPECT_NEAR(in_wall_coordinates.error->moments.y1, solution.error->moments.y1, 1e-12);
  EXPECT_NEAR(in_wall_coordinates.error->moments.y4, solution.error->moments.y4, 1e-12);
}

TEST(ResidualErrorEstimate, IsUnsupportedIfTheLawHasAnAtom) {
  const problem::System pressed(
      {.damping = 0.1, .constant = 0.5, .stiffness = 1, .restitution = 0.7});
  Solution solution;
  solution.status = Status::ok;
  solution.density =
      transform::SmoothDensity{[](double y, double v) { return std::exp(-(y * y + v * v)); }, 6, 6};
  set_residual_error_estimate(
      ResidualErrorEstimator(tests::with_impulses(pressed, tests::gaussian_impulses(1, 0.5))), 1,
      solution);
  EXPECT_FALSE(solution.error);
  EXPECT_EQ(solution.status, Status::inaccurate);
  EXPECT_NE(solution.reason.find("atom"), std::string::npos) << solution.reason;
}

/// A system with two wells that exchange mass about once in exp(14) oscillations, and its exact
/// density.
struct DeepWells {
  problem::Problem problem = tests::with_noise(
      problem::System({.damping = 0.2, .constant = 0.02, .stiffness = -1, .cubic = 1},
                      {.none = true}),
      0.007);
  exact::EnergyLaw law{problem};

  Solution solution(const transform::SolutionIdentity& identity) const {
    Solution exact;
    exact.identity = identity;
    exact.status = Status::ok;
    exact.density = transform::SmoothDensity{law, 2, 1.5, -2};
    return exact;
  }
};

TEST(ResidualErrorEstimate, IsUnknownIfResidualsDoNotDetermineTheMassesOfWells) {
  const DeepWells wells;
  auto solution = wells.solution({});
  set_residual_error_estimate(ResidualErrorEstimator(wells.problem), 0.02, solution);
  EXPECT_FALSE(solution.error);
  EXPECT_EQ(solution.status, Status::inaccurate);
  EXPECT_NE(solution.reason.find("unknown"), std::string::npos) << solution.reason;
}

TEST(ResidualErrorEstimate, IsReplacedByTheDistanceFromTheReference) {
  const DeepWells wells;
  std::vector<Method> methods(2);
  auto &closure = methods[0].identity, &best = methods[1].identity;
  closure.id = "mine";
  closure.role = transform::SolutionRole::closure;
  methods[0].options = {{"accuracy", 0.02}};
  best.id = "best";
  best.role = transform::SolutionRole::equation;
  best.equation = problem::DensityEquation::kf;
  best.impact = problem::ImpactCondition::map;
  std::vector<Solution> solutions{wells.solution(closure), wells.solution(best)};
  solutions[1].error = transform::ErrorEstimate{.y_l1 = 0.004, .ydot_l1 = 0.003};
  const ResidualErrorEstimator residuals(wells.problem);
  set_residual_error_estimate(residuals, 0.02, solutions[0]);
  ASSERT_EQ(solutions[0].status, Status::inaccurate);
  complete_error_estimates(methods, compare::comparison_bins(wells.problem), residuals, solutions);
  EXPECT_EQ(solutions[0].status, Status::ok) << solutions[0].reason;
  EXPECT_EQ(solutions[0].reason, "");
  ASSERT_TRUE(solutions[0].error);
  EXPECT_NEAR(solutions[0].error->y_l1, 0.004, 1e-12);
}

TEST(ResidualErrorEstimator, FitsOnceForAllThreads) {
  const ResidualErrorEstimator residuals(tests::paper_case(2));
  std::vector<const backward::DensityErrorEstimator*> seen(4);
  {
    std::vector<std::jthread> threads;
    for (auto& one : seen) threads.emplace_back([&] { one = residuals.density_error_estimator(); });
  }
  EXPECT_NE(seen[0], nullptr);
  for (const auto* one : seen) EXPECT_EQ(one, seen[0]);
}

}  // namespace
}  // namespace fpkcheck::methods
