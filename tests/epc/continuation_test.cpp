#include "epc/continuation.hpp"

#include <gtest/gtest.h>

#include "paper_cases.hpp"

namespace fpkcheck::epc {
namespace {

Projection projection_of(const problem::Problem& problem, int order) {
  return Projection(Basis(order, MonomialSet::point_symmetric,
                          deviations(problem::equivalent_linearisation(problem))));
}

TEST(Continuation, ReachesTheRootOfPlainNewtonSteps) {
  for (int number = 1; number <= 3; ++number) {
    const problem::Problem p = tests::paper_case(number);
    const auto [s1, s2] = deviations(problem::equivalent_linearisation(p));
    const Projection projection = projection_of(p, 6);
    const ResidualCoefficients f = residual_coefficients(p, Equation::km4);
    const auto start =
        projection.basis().scaled({{2, 0, -1 / (2 * s1 * s1)}, {0, 2, -1 / (2 * s2 * s2)}});
    const NewtonResult plain = newton(projection, f, start, {});
    const Branch branch = follow_branch(projection, f, 1e-10);
    ASSERT_TRUE(plain.converged);
    ASSERT_EQ(branch.reached, 1);
    EXPECT_LT((plain.a - branch.a).norm(), 1e-10);
  }
}

// Theory notes, section 5: at n = 8 the branch turns back before the full problem.
TEST(Continuation, StopsWhereTheBranchTurnsBack) {
  const problem::Problem p = tests::paper_case(1);
  const Projection projection = projection_of(p, 8);
  const ResidualCoefficients f = residual_coefficients(p, Equation::km4);
  const Branch branch = follow_branch(projection, f, 1e-10);
  EXPECT_NEAR(branch.reached, 0.655, 0.002);
  EXPECT_LT(branch.residual, 1e-10);
  const auto singular_values =
      projection.jacobian(partway(f, branch.reached), branch.a).jacobiSvd().singularValues();
  EXPECT_LT(singular_values.minCoeff(), 1e-4);
}

TEST(Continuation, PathBeginsWithWhiteNoiseAndNoLoss) {
  const ResidualCoefficients full =
      residual_coefficients(tests::make_problem({.restitution = 0.7, .mean = 0.1}), Equation::km4);
  const ResidualCoefficients start = partway(full, 0), half = partway(full, 0.5);
  EXPECT_EQ(start.impact_loss, 0);
  EXPECT_EQ(start.rate_moment[1], 0);
  EXPECT_EQ(start.rate_moment[2], full.rate_moment[2]);
  EXPECT_EQ(start.rate_moment[3], 0);
  EXPECT_EQ(start.rate_moment[4], 0);
  EXPECT_DOUBLE_EQ(half.rate_moment[4], full.rate_moment[4] / 2);
  EXPECT_DOUBLE_EQ(half.impact_loss, 0.15);
}

TEST(Newton, StopsAfterTheStepsAllowed) {
  const problem::Problem p = tests::paper_case(1);
  const Projection projection = projection_of(p, 4);
  const Eigen::VectorXd start = Eigen::VectorXd::Zero(projection.basis().size());
  const auto f = residual_coefficients(p, Equation::km4);
  const NewtonResult one = newton(projection, f, start, {.tolerance = 1e-10, .max_iterations = 1});
  EXPECT_EQ(one.iterations, 1);
  EXPECT_FALSE(one.converged);
  EXPECT_NEAR(one.residual, projection.residual(f, one.a).cwiseAbs().maxCoeff() / 0.1, 1e-12);
}

}  // namespace
}  // namespace fpkcheck::epc
