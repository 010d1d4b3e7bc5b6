#include "compare/guaranteed_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::compare {
namespace {

using transform::Solution;

GuaranteedBounds narrow() {
  return {.each = {{"E[y^2]", 0.39, 0.40}, {"E[y'^2]", 0.44, 0.45}, {"w1", 0.1, 0.2}}};
}

Solution with_moments(const std::string& id, double y2, double v2) {
  Solution solution;
  solution.identity.id = id;
  solution.had_density = true;
  solution.moments.y2 = y2;
  solution.moments.v2 = v2;
  return solution;
}

TEST(BoundViolation, IsFoundAtBothEnds) {
  const std::vector<Solution> solutions{with_moments("in", 0.39, 0.45),
                                        with_moments("below", 0.385, 0.445),
                                        with_moments("above", 0.395, 0.452)};
  const GuaranteedBounds bounds = narrow();
  const auto found = bound_violations(bounds, solutions);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].solution->id(), "below");
  EXPECT_EQ(found[0].bound->functional, "E[y^2]");
  EXPECT_NEAR(found[0].excess, 0.005, 1e-15);
  EXPECT_EQ(found[1].solution->id(), "above");
  EXPECT_EQ(found[1].bound->functional, "E[y'^2]");
  EXPECT_NEAR(found[1].excess, 0.002, 1e-15);
}

TEST(BoundViolation, IsAContradictionBeyondTheErrorEstimate) {
  std::vector<Solution> solutions{with_moments("fd", 0.388, 0.445)};
  const GuaranteedBounds bounds = narrow();
  EXPECT_TRUE(bound_violations(bounds, solutions).at(0).exceeds_error_estimate());
  solutions[0].error.emplace().moments.y2 = 0.0019;
  EXPECT_TRUE(bound_violations(bounds, solutions).at(0).exceeds_error_estimate());
  solutions[0].error->moments.y2 = 0.0021;
  EXPECT_FALSE(bound_violations(bounds, solutions).at(0).exceeds_error_estimate());
}

TEST(BoundViolation, IsNoContradictionWithinFourStandardErrors) {
  std::vector<Solution> solutions{with_moments("mcs", 0.388, 0.445)};
  const GuaranteedBounds bounds = narrow();
  solutions[0].standard_errors.emplace().moments.y2 = 0.0006;
  EXPECT_FALSE(bound_violations(bounds, solutions).at(0).exceeds_error_estimate());
  solutions[0].standard_errors->moments.y2 = 0.0004;
  EXPECT_TRUE(bound_violations(bounds, solutions).at(0).exceeds_error_estimate());
}

TEST(Contradictions, AreReportedForSolutionsOfTheFullProblemOnly) {
  std::vector<Solution> solutions{with_moments("white", 0.5, 0.5), with_moments("fd", 0.5, 0.445)};
  for (auto& solution : solutions) {
    solution.status = transform::Status::ok;
    solution.identity.role = transform::SolutionRole::equation;
    solution.identity.equation = problem::DensityEquation::kf;
    solution.identity.impact = problem::ImpactCondition::map;
  }
  solutions[0].identity.equation = problem::DensityEquation::white;
  const GuaranteedBounds bounds = narrow();
  const auto found = violations_beyond_error_estimate(bounds, solutions);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].solution->id(), "fd");
  solutions[1].error.emplace().moments.y2 = 0.2;
  EXPECT_TRUE(violations_beyond_error_estimate(bounds, solutions).empty());
}

TEST(BoundViolation, IsNotReportedForUnknownMoments) {
  const GuaranteedBounds bounds = narrow();
  EXPECT_TRUE(
      bound_violations(bounds, std::vector{with_moments("file", 0.395, std::nan(""))}).empty());
  auto none = with_moments("none", 0, 0);
  none.had_density = false;
  EXPECT_TRUE(bound_violations(bounds, std::vector{none}).empty());
  EXPECT_TRUE(bound_violations({.reason = "no"}, std::vector{with_moments("any", 9, 9)}).empty());
}

}  // namespace
}  // namespace fpkcheck::compare
