#include "problem/balances.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "paper_cases.hpp"

namespace fpkcheck::problem {
namespace {

constexpr double kRounding = 1e-14;

// A linear oscillator under white noise at an elastic wall: Gaussian densities folded at y = 0,
// with deviations s of y and w = sqrt(k) s of v.
TEST(MotionBalances, HoldForTheFoldedGaussianOfTheLinearElasticOscillator) {
  const double k = 2, s = 0.7, w = std::sqrt(k) * s;
  const Problem p = tests::make_problem({.stiffness = k, .cubic = 0, .restitution = 1});
  const double mean = s * std::sqrt(2 / std::numbers::pi);
  EXPECT_NEAR(
      virial_balance(
          p, {.mean_displacement = mean, .mean_square_velocity = w * w, .mean_virial = k * s * s})
          .relative_balance_residual(),
      0, kRounding);
  // p(0, -u) is 2 / (sqrt(2 pi) s) times the Gaussian density of u; u > 0 has half of E[u^2].
  const double momentum = 2 / (std::sqrt(2 * std::numbers::pi) * s) * w * w / 2;
  EXPECT_NEAR(momentum_balance(p, {.mean_force = k * mean, .left_impact_momentum = 2 * momentum})
                  .relative_balance_residual(),
              0, kRounding);
}

TEST(MotionBalances, CountTheMeanOfTheImpulsesAndTheLossesAtTheWall) {
  const Problem p =
      tests::make_problem({.restitution = 0.6, .rate = 2, .intensity = 0.5, .mean = 0.1});
  // 0.5 = 0.56 - 0.2 * 0.3, and 0.68 = 0.2 + 1.6 * 0.3
  EXPECT_NEAR(impact_momentum_rate(p.system.left_wall(), 0.3), 1.6 * 0.3, kRounding);
  EXPECT_NEAR(virial_balance(
                  p, {.mean_displacement = 0.3, .mean_square_velocity = 0.5, .mean_virial = 0.56})
                  .relative_balance_residual(),
              0, kRounding);
  EXPECT_NEAR(momentum_balance(p, {.mean_force = 0.68, .left_impact_momentum = 1.6 * 0.3})
                  .relative_balance_residual(),
              0, kRounding);
}

TEST(MotionBalances, AreRelativeToTheVelocityAndToTheLargerForce) {
  const Problem out = tests::make_problem({.restitution = 0.5, .mean = 0.1});
  EXPECT_NEAR(virial_balance(
                  out, {.mean_displacement = 1, .mean_square_velocity = 0.5, .mean_virial = 0.55})
                  .relative_balance_residual(),
              0.1, kRounding);  // 0.5 - (0.55 - 0.1)
  EXPECT_NEAR(momentum_balance(out, {.mean_force = 0.5, .left_impact_momentum = 0.3})
                  .relative_balance_residual(),
              0.2,
              kRounding);  // 0.5 - 0.1 - 0.3
  const Problem in = tests::make_problem({.restitution = 0.5, .mean = -0.1});
  EXPECT_NEAR(momentum_balance(in, {.mean_force = 0.1, .left_impact_momentum = 0.3})
                  .relative_balance_residual(),
              -0.1 / 0.3, kRounding);  // 0.1 + 0.1 - 0.3
}

}  // namespace
}  // namespace fpkcheck::problem
