#include "numerics/roots/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "numerics/roots/difference_jacobian.hpp"

namespace fpkcheck::numerics {
namespace {

using Eigen::VectorXd;

// The equation atan(a) = 0, for which full Newton steps diverge from |a| > 1.39.
struct Arctangent {
  struct Iterate {
    VectorXd a;
    double size;
  };
  struct Step {
    VectorXd change;
  };
  Iterate at(const VectorXd& a) const { return {a, std::abs(std::atan(a[0]))}; }
  Step step(const Iterate& here) const {
    const double a = here.a[0];
    return {VectorXd::Constant(1, -std::atan(a) * (1 + a * a))};
  }
  double step_fraction(const Iterate& here, const Step& step) const {
    return halve_step_until_accepted(1, 1e-3, [&](double step_fraction) {
      return at(here.a + step_fraction * step.change).size < here.size;
    });
  }
};

NewtonResult from(double start, const NewtonOptions& options) {
  return solve_by_newton(Arctangent{}, VectorXd::Constant(1, start), options);
}

TEST(Newton, DampedStepsConvergeWhereFullStepsDiverge) {
  const NewtonResult damped = from(3, {}), whole = from(3, {.damped = false});
  EXPECT_TRUE(damped.converged);
  EXPECT_NEAR(damped.a[0], 0, 1e-15);
  EXPECT_FALSE(whole.converged);
  EXPECT_EQ(whole.a[0], 3);  // the start has the smallest residual
  EXPECT_TRUE(from(1, {.damped = false}).converged);
}

TEST(Newton, PolishingAddsOneStep) {
  const NewtonResult rough = from(1, {.tolerance = 1e-2, .polish = false});
  const NewtonResult polished = from(1, {.tolerance = 1e-2});
  EXPECT_TRUE(rough.converged);
  EXPECT_EQ(polished.iterations, rough.iterations + 1);
  EXPECT_LT(polished.residual, rough.residual);
  EXPECT_EQ(from(0, {}).iterations, 1);  // the start is the root
  EXPECT_EQ(from(0, {.polish = false}).iterations, 0);
}

TEST(Newton, TakesNoMoreStepsThanAllowed) {
  EXPECT_EQ(from(1.3, {.max_iterations = 2}).iterations, 2);
  const NewtonResult none = from(1e-12, {.max_iterations = 0});
  EXPECT_EQ(none.iterations, 0);
  EXPECT_TRUE(none.converged);
}

TEST(Newton, EndsWhereThereIsNoResidual) {
  const NewtonResult result = from(std::numeric_limits<double>::quiet_NaN(), {});
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 0);
}

TEST(Backtrack, ReturnsTheFirstAcceptedFraction) {
  EXPECT_EQ(
      halve_step_until_accepted(1, 1e-3, [](double step_fraction) { return step_fraction < 0.3; }),
      0.25);
  EXPECT_EQ(halve_step_until_accepted(0.7, 1e-3, [](double) { return true; }), 0.7);
  EXPECT_EQ(halve_step_until_accepted(1, 1e-3, [](double) { return false; }), 0);
}

// R(a) = (exp(a0) - a1, a0 a1 - 1) with the Jacobian ((exp(a0), -1), (a1, a0)); at the root a1 is
// 1/a0 and a0 is the omega constant, 0.5671432904097838.
TEST(EquationsWithDifferenceJacobian, HaveTheExactJacobianAndRoot) {
  const EquationsWithDifferenceJacobian equations([](const Eigen::VectorXd& a) -> Eigen::VectorXd {
    return Eigen::Vector2d(std::exp(a(0)) - a(1), a(0) * a(1) - 1);
  });
  const Eigen::Vector2d at(0.3, 0.7);
  Eigen::Matrix2d exact;
  exact << std::exp(0.3), -1, 0.7, 0.3;
  EXPECT_LT((equations.jacobian_at(at) - exact).cwiseAbs().maxCoeff(), 1e-9);
  const NewtonResult result = solve_by_newton(equations, at, {});
  EXPECT_TRUE(result.converged);
  EXPECT_NEAR(result.a(0), 0.5671432904097838, 1e-12);
  EXPECT_NEAR(result.a(1), 1 / 0.5671432904097838, 1e-12);
}

}  // namespace
}  // namespace fpkcheck::numerics
