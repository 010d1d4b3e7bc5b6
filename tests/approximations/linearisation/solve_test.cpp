#include "approximations/linearisation/solve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "general_oscillators.hpp"
#include "paper_cases.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::linearisation {
namespace {

using problem::System;
using transform::Status;

constexpr double kTolerance = 1e-8;
const problem::WallParameters kNoWall{.none = true};

transform::Solution solve_ok(const problem::Problem& problem,
                             const LinearisationOptions& options = {}) {
  auto solution = solve_moment_equations(tests::in_wall_coordinates(problem), options);
  EXPECT_EQ(solution.status, Status::ok) << solution.reason;
  EXPECT_NEAR(solution.mass, 1, kTolerance);
  EXPECT_NEAR(solution.energy_residual, 0, kTolerance);
  return solution;
}

TEST(Linearisation, IsExactForALinearOscillator) {
  const double c = 0.2, k = 2, rate = 3, intensity = 0.5, mean = 0.1;
  const auto moments =
      solve_ok(tests::with_impulses(System({.damping = c, .stiffness = k}, kNoWall),
                                    tests::gaussian_impulses(rate, intensity, mean)))
          .moments;
  const double deflection = rate * mean / k;
  EXPECT_NEAR(moments.y1, deflection, kTolerance);
  EXPECT_NEAR(moments.y2, intensity / (2 * c * k) + deflection * deflection, kTolerance);
  EXPECT_NEAR(moments.v2, intensity / (2 * c), kTolerance);
}

TEST(Linearisation, IsExactAtAnElasticWallAtTheEquilibrium) {
  const auto moments = solve_ok(tests::make_problem({.cubic = 0, .restitution = 1})).moments;
  EXPECT_NEAR(moments.y1, std::sqrt(0.5 * 2 / std::numbers::pi), kTolerance);
  EXPECT_NEAR(moments.y2, 0.5, kTolerance);
  EXPECT_NEAR(moments.v4, 3 * 0.25, kTolerance);
}

// Caughey 1963: sigma^2 (k + 3 mu sigma^2) = D / c.
TEST(Linearisation, HasTheEquivalentStiffnessOfTheDuffingOscillator) {
  const double c = 0.1, mu = 0.5, intensity = 0.3;
  const auto moments =
      solve_ok(tests::with_noise(System({.damping = c, .stiffness = 1, .cubic = mu}, kNoWall),
                                 intensity))
          .moments;
  EXPECT_NEAR(moments.v2, intensity / (2 * c), kTolerance);
  EXPECT_NEAR(moments.y2 * (1 + 3 * mu * moments.y2), intensity / (2 * c), kTolerance);
}

TEST(Linearisation, WithTheImpactDeltaIsThePapersEquivalentLinearisation) {
  for (const double restitution : {0.98, 0.8, 0.5}) {
    const auto problem = tests::make_problem({.cubic = 1, .restitution = restitution});
    const auto exact = problem::equivalent_linearisation(problem);
    const auto moments = solve_ok(problem, {.impact = problem::ImpactCondition::delta}).moments;
    EXPECT_NEAR(std::sqrt(moments.y2), exact.displacement_deviation, kTolerance) << restitution;
    EXPECT_NEAR(std::sqrt(moments.v2), exact.velocity_deviation, kTolerance) << restitution;
  }
}

// The flux of impacts with the speed u at the wall is 2 u phi(0) phi(u / s_v) / (s_y s_v), with
// int u^3 phi(u / s_v) du / s_v = s_v^3 sqrt(2 / pi).
TEST(Linearisation, LosesTheEnergyOfImpacts) {
  const double c = 0.1, r = 0.6, intensity = 0.1;
  const auto moments =
      solve_ok(tests::make_problem({.damping = c, .restitution = r, .intensity = intensity}))
          .moments;
  const double loss =
      (1 - r * r) * std::pow(moments.v2, 1.5) / std::sqrt(moments.y2) / std::numbers::pi;
  EXPECT_NEAR(c * moments.v2 + loss, intensity / 2, kTolerance);
}

// E[v sgn v] = s_v sqrt(2 / pi); the panels of the quadrature end at the jump.
TEST(Linearisation, IntegratesAcrossTheJumpOfDryFriction) {
  const double friction = 0.2, intensity = 0.4;
  const auto moments =
      solve_ok(tests::with_noise(System({.force = "0.2 * sign(v) + y"}, kNoWall), intensity))
          .moments;
  EXPECT_NEAR(friction * std::sqrt(moments.v2 * 2 / std::numbers::pi), intensity / 2, kTolerance);
  EXPECT_NEAR(moments.y2, moments.v2, kTolerance);
}

// The bouncing ball, g = 1: E[v^2] = E[y g] = s_y sqrt(2 / pi).
TEST(Linearisation, BalancesTheVirialOfAConstantForce) {
  const auto moments =
      solve_ok(tests::with_noise(System({.damping = 0.2, .constant = 1, .restitution = 0.9}), 1))
          .moments;
  EXPECT_NEAR(moments.v2, std::sqrt(moments.y2 * 2 / std::numbers::pi), kTolerance);
}

TEST(Linearisation, DoesNotSupportTwoWalls) {
  const problem::WallParameters walls{
      .left = -1, .left_restitution = 0.9, .right = 1, .right_restitution = 0.9};
  const auto problem = tests::in_wall_coordinates(
      tests::with_noise(System({.damping = 0.1, .stiffness = 1}, walls), 0.1));
  EXPECT_NE(unsupported_reason(problem, {}), "");
}

}  // namespace
}  // namespace fpkcheck::linearisation
