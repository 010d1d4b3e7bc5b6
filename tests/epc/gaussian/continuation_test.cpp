#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "epc/gaussian/continuation.hpp"
#include "epc/selection_policy.hpp"
#include "gaussian/projection_of.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

using numerics::NewtonResult;

TEST(Continuation, ReachesTheRootOfPlainNewtonSteps) {
  for (int number = 1; number <= 3; ++number) {
    const problem::Problem p = tests::paper_case(number);
    const auto [s1, s2] = gaussian_weight_deviations(p);
    const ProjectedEquations projection = projection_of(p, 6);
    const DensityEquationCoefficients f = residual_coefficients(p, DensityEquation::km4);
    const auto start = projection.basis().scaled_coefficients(
        {{2, 0, -1 / (2 * s1 * s1)}, {0, 2, -1 / (2 * s2 * s2)}});
    const NewtonResult plain = solve_by_newton(projection, f, start, {.damped = false});
    const NewtonResult damped = solve_by_newton(projection, f, start, {});
    const auto [branch, root] = follow_solution_branch(projection, f, 1e-10);
    ASSERT_TRUE(plain.converged);
    ASSERT_TRUE(damped.converged);
    ASSERT_EQ(branch.end, SolutionBranchEndReason::full_problem);
    EXPECT_EQ(branch.furthest, 1);
    EXPECT_LT((plain.a - root.a).norm(), 1e-10);
    EXPECT_LT((plain.a - damped.a).norm(), 1e-10);
  }
}

// At n = 8 the branch has a fold before the full problem and returns to fraction 0.
TEST(Continuation, GoesPastTheFoldAndBackToWhiteNoise) {
  const problem::Problem p = tests::paper_case(1);
  const ProjectedEquations projection = projection_of(p, 8);
  const auto [branch, root] =
      follow_solution_branch(projection, residual_coefficients(p, DensityEquation::km4), 1e-10);
  EXPECT_FALSE(root.converged);
  EXPECT_EQ(branch.end, SolutionBranchEndReason::white_noise);
  EXPECT_NEAR(branch.furthest, 0.65475, 1e-5);
  EXPECT_EQ(branch.points.front().fraction, 0);
  EXPECT_EQ(branch.points.back().fraction, 0);
  EXPECT_GT(std::abs(branch.points.back().norm - branch.points.front().norm), 0.01);
  EXPECT_EQ(std::ranges::count_if(branch.points, &SolutionBranchPoint::fold), 1);
  const auto fold = std::ranges::find_if(branch.points, &SolutionBranchPoint::fold);
  EXPECT_EQ(fold->fraction, branch.furthest);
  EXPECT_LT(fold->smallest_singular_value, 1e-9);
  EXPECT_EQ(branch.points.front().determinant_sign, -branch.points.back().determinant_sign);
  EXPECT_TRUE(branch.points.front().falls);
  EXPECT_FALSE(fold->falls);
}

TEST(Continuation, AddsTheEquationsOfTheNextOrder) {
  const problem::Problem p = tests::make_problem({.rate = 10});
  const DensityEquationCoefficients f = residual_coefficients(p, DensityEquation::km4);
  const ProjectedEquations four = projection_of(p, 4), six = projection_of(p, 6);
  const auto [branch, before] = follow_solution_branch(four, f, 1e-10);
  ASSERT_TRUE(before.converged);
  const Eigen::VectorXd start =
      six.basis().scaled_coefficients(four.basis().exponent_polynomial(before.a).terms());
  // The equations of n = 4 are among those of n = 6.
  EXPECT_LT(six.residual(f, start).head(8).norm(), 1e-12);
  const NewtonResult root = follow_newton_homotopy(six, f, start, 1e-10);
  EXPECT_TRUE(root.converged);
  EXPECT_LT(six.residual(f, root.a).norm(), 1e-11);
}

// The exact density under white noise is the start for springs of other powers, too.
TEST(Continuation, StartsFromTheExactDensityOfAQuinticSpring) {
  const problem::Problem p = tests::make_problem({.restitution = 1});
  const ProjectedEquations projection = projection_of(p, 6);
  DensityEquationCoefficients f = residual_coefficients(p, DensityEquation::white);
  f.odd_force = numerics::Polynomial({0, 1, 0, 0.1, 0, 0.02});
  const auto [branch, root] = follow_solution_branch(projection, f, 1e-10);
  EXPECT_EQ(branch.end, SolutionBranchEndReason::full_problem);
  EXPECT_TRUE(root.converged);
  const double beta = f.damping / (f.rate_times_moment[2] / 2);
  const Eigen::VectorXd exact = projection.basis().scaled_coefficients(
      {{0, 2, -beta / 2}, {2, 0, -beta / 2}, {4, 0, -beta * 0.1 / 4}, {6, 0, -beta * 0.02 / 6}});
  EXPECT_LT((root.a - exact).norm(), 1e-10);
}

TEST(Continuation, StartsNearTheDensityOfASpringOfEvenPowers) {
  const problem::Problem p = tests::make_problem({});
  const ProjectedEquations projection = projection_of(p, 6);
  DensityEquationCoefficients f = residual_coefficients(p, DensityEquation::km4);
  f.even_force = numerics::Polynomial({0, 0, 0.2});
  const auto [branch, root] = follow_solution_branch(projection, f, 1e-10);
  EXPECT_EQ(branch.end, SolutionBranchEndReason::full_problem);
  EXPECT_TRUE(root.converged);
  EXPECT_LT(projection.residual(f, root.a).norm(), 1e-10);
}

TEST(Continuation, PathBeginsWithWhiteNoiseAndNoLoss) {
  const DensityEquationCoefficients full = residual_coefficients(
      tests::make_problem({.restitution = 0.7, .mean = 0.1}), DensityEquation::km4);
  const DensityEquationCoefficients start = homotopy_coefficients(full, 0),
                                    half = homotopy_coefficients(full, 0.5);
  EXPECT_EQ(start.impact_loss, 0);
  EXPECT_EQ(start.rate_times_moment[1], 0);
  EXPECT_EQ(start.rate_times_moment[2], full.rate_times_moment[2]);
  EXPECT_EQ(start.rate_times_moment[3], 0);
  EXPECT_EQ(start.rate_times_moment[4], 0);
  EXPECT_DOUBLE_EQ(half.rate_times_moment[4], full.rate_times_moment[4] / 2);
  EXPECT_DOUBLE_EQ(half.impact_loss, 0.15);
  const DensityEquationCoefficients jumps =
      residual_coefficients(tests::paper_case(1), DensityEquation::kf);
  EXPECT_EQ(full.jump_fraction, 0);
  EXPECT_EQ(jumps.jump_fraction, 1);
  EXPECT_EQ(homotopy_coefficients(jumps, 0).jump_fraction, 0);
  EXPECT_DOUBLE_EQ(homotopy_coefficients(jumps, 0.25).jump_fraction, 0.25);
}

}  // namespace
}  // namespace fpkcheck::epc::gaussian
