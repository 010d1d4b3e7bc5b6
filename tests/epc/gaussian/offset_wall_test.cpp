#include <gtest/gtest.h>

#include <cmath>

#include "closures.hpp"
#include "epc/closed_form_density.hpp"
#include "epc/gaussian/residual.hpp"
#include "epc/solve.hpp"
#include "exact/energy_law.hpp"
#include "general_oscillators.hpp"

// The paper's closure with a wall away from the equilibrium: the plane is folded at the wall, and
// the force has even powers. The lowest power is the constant force on the mass at the wall.
namespace fpkcheck::epc::gaussian {
namespace {

using problem::System;
using problem::WallParameters;
using transform::Status;

problem::Problem elastic_problem(const WallParameters& walls, double intensity) {
  return tests::with_noise(System({.damping = 0.2, .stiffness = 1, .cubic = 0.3}, walls),
                           intensity);
}

// The residual of the exact density vanishes on both sides of the fold, with
// Q = -(c/D)(x2^2/2 + U(|x1|)).
TEST(GaussianClosureBehindAnOffsetWall, TheExactElasticDensityMeetsItsEquation) {
  for (const double wall : {-0.5, 0.3}) {
    const auto p =
        tests::in_wall_coordinates(elastic_problem({.left = wall, .left_restitution = 1}, 0.4));
    const auto f = residual_coefficients(p, problem::DensityEquation::km4);
    const double beta = 0.2 / 0.2;  // c/D
    for (const double x1 : {-1.3, -0.2, 0.1, 0.8}) {
      for (const double x2 : {-0.7, 0.4}) {
        const double side = x1 > 0 ? 1 : -1, y = std::abs(x1) + wall;
        const double force = y + 0.3 * y * y * y;
        const ExponentPartialDerivatives q{
            .q1 = -beta * side * force, .q2 = -beta * x2, .q22 = -beta, .q222 = 0, .q2222 = 0};
        EXPECT_NEAR(residual_part_without_x1_sign(f, x1, x2, q) +
                        side * residual_part_odd_in_x1_sign(f, x1, q),
                    0, 1e-13);
      }
    }
    EXPECT_EQ(f.impact_loss, 0);
  }
}

// The exponent has a kink at the fold: no order is exact.
TEST(GaussianClosureBehindAnOffsetWall, ApproximatesTheExactElasticLaw) {
  const auto p = elastic_problem({.left = 0.2, .left_restitution = 1}, 0.4);
  const exact::EnergyLaw law(p);
  const auto relative_error = [&](int order) {
    const auto solution = solve_closure(tests::in_wall_coordinates(p),
                                        tests::closure_options(Formulation::gaussian, order))
                              .solution;
    EXPECT_TRUE(solution.density) << solution.reason;
    EXPECT_NEAR(solution.moments.v2, law.moment(0, 2), 1e-3 * law.moment(0, 2)) << order;
    return std::abs(solution.moments.y2 / law.moment(2, 0) - 1);
  };
  const double second = relative_error(2);
  EXPECT_LT(relative_error(4), second / 3);
  EXPECT_LT(relative_error(6), second / 3);
  EXPECT_LT(relative_error(6), 1e-3);
}

TEST(GaussianClosureBehindAnOffsetWall, IsTheSameInAMirror) {
  const auto impulses = tests::gaussian_impulses(2, 0.4, 0.05),
             turned = tests::gaussian_impulses(2, 0.4, -0.05);
  const problem::SystemCoefficients spring{.damping = 0.2, .constant = 0.1, .stiffness = 1};
  problem::SystemCoefficients reflected = spring;
  reflected.constant = -spring.constant;
  const auto left =
      solve_closure(tests::in_wall_coordinates(tests::with_impulses(
                        System(spring, {.left = -0.05, .left_restitution = 0.95}), impulses)),
                    tests::closure_options(Formulation::gaussian, 6))
          .solution;
  const auto right =
      solve_closure(tests::in_wall_coordinates(tests::with_impulses(
                        System(reflected, {.right = 0.05, .right_restitution = 0.95}), turned)),
                    tests::closure_options(Formulation::gaussian, 6))
          .solution;
  ASSERT_TRUE(left.density && right.density) << left.reason << right.reason;
  EXPECT_NEAR(left.moments.y1, -right.moments.y1, 1e-12);
  EXPECT_NEAR(left.moments.v2, right.moments.v2, 1e-12);
}

}  // namespace
}  // namespace fpkcheck::epc::gaussian
