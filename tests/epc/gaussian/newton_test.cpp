#include <gtest/gtest.h>

#include "epc/gaussian/projected_equations.hpp"
#include "epc/gaussian/residual.hpp"
#include "gaussian/projection_of.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

using numerics::NewtonResult;

TEST(GaussianNewton, StopsAfterTheStepsAllowed) {
  const problem::Problem p = tests::paper_case(1);
  const ProjectedEquations projection = projection_of(p, 4);
  const Eigen::VectorXd start = Eigen::VectorXd::Zero(projection.basis().size());
  const auto f = residual_coefficients(p, DensityEquation::km4);
  const NewtonResult one =
      solve_by_newton(projection, f, start, {.max_iterations = 1, .damped = false});
  EXPECT_EQ(one.iterations, 1);
  EXPECT_FALSE(one.converged);
  EXPECT_NEAR(one.residual, projection.residual(f, one.a).cwiseAbs().maxCoeff() / 0.1, 1e-12);
}

// A damped iteration may stall, but the residual does not grow.
TEST(GaussianNewton, DampedStepsNeverRaiseTheResidual) {
  const problem::Problem p = tests::paper_case(1);
  const ProjectedEquations projection = projection_of(p, 8);
  const auto f = residual_coefficients(p, DensityEquation::km4);
  const auto [s1, s2] = projection.basis().weight_standard_deviations();
  const Eigen::VectorXd start = projection.basis().scaled_coefficients(
      {{2, 0, -1 / (2 * s1 * s1)}, {0, 2, -1 / (2 * s2 * s2)}});
  double before = projection.residual(f, start).norm();
  for (int steps = 1; steps <= 6; ++steps) {
    const NewtonResult result = solve_by_newton(projection, f, start, {.max_iterations = steps});
    EXPECT_FALSE(result.converged);
    EXPECT_LE(projection.residual(f, result.a).norm(), 1.05 * before);
    before = projection.residual(f, result.a).norm();
  }
}

TEST(GaussianNewton, ResidualUnitHasALowerLimit) {
  const problem::Problem p = tests::make_problem({.damping = 1e-7});
  const ProjectedEquations projection = projection_of(p, 4);
  const auto f = residual_coefficients(p, DensityEquation::km4);
  const auto [s1, s2] = projection.basis().weight_standard_deviations();
  EXPECT_DOUBLE_EQ(unit_of_projected_residual(projection, f), 1e-4 * s2 / s1);
  EXPECT_DOUBLE_EQ(
      unit_of_projected_residual(projection_of(tests::paper_case(1), 4),
                                 residual_coefficients(tests::paper_case(1), DensityEquation::km4)),
      0.1);
}

}  // namespace
}  // namespace fpkcheck::epc::gaussian
