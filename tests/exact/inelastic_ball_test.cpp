#include "exact/inelastic_ball.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/input_error.hpp"
#include "trapezoid.hpp"

namespace fpkcheck::exact {
namespace {

// q = e^-u solves the integral equation of the impact speeds; quadrature in x = log u.
TEST(InelasticBall, ImpactSpeedsAreExponentialForOneHalf) {
  for (const double a : {0.03, 0.4, 1.0, 3.0}) {
    const double returned = tests::trapezoid(
        [&](double x) {
          const double u = std::exp(x);
          return InelasticBall::kernel(a, u / 2) * std::exp(-u) * u;
        },
        -25, 5, 400);
    EXPECT_NEAR(returned / std::exp(-a), 1, 1e-8) << a;
  }
  const InelasticBall ball(0.5);
  EXPECT_NEAR(ball.impact_rate(), 2.0 / 3, 1e-8);
  EXPECT_NEAR(ball.mean_height(), 1.5, 1e-8);
  EXPECT_NEAR(ball.fourth_velocity_moment(), 13.5, 1e-7);
  for (int n = 2; n <= 5; ++n) EXPECT_NEAR(ball.speed_moment(n) / std::tgamma(n + 1), 1, 1e-8);
}

// The noise increases E[v^2] by 2D per unit time, the impacts decrease it: E[u^2] = E[u] / (1 - r).
TEST(InelasticBall, MeetsTheBalanceOfPower) {
  for (const double r : {0.5, 0.7, 0.8}) {
    const InelasticBall ball(r);
    EXPECT_NEAR(ball.speed_moment(2) * (1 - r) / ball.speed_moment(1), 1, 1e-8) << r;
  }
}

// Reference values from an independent program with other nodes.
TEST(InelasticBall, AgreesWithIndependentValues) {
  const InelasticBall ball(0.7);
  EXPECT_NEAR(ball.impact_rate(), 0.28914363, 1e-8);
  EXPECT_NEAR(ball.mean_height(), 4.0524874, 1e-7);
  EXPECT_NEAR(ball.fourth_velocity_moment(), 81.09507, 1e-5);
}

TEST(InelasticBall, RefusesProblemsWithoutStationaryMotion) {
  EXPECT_THROW(InelasticBall(1.0), InputError);
  EXPECT_THROW(InelasticBall(0.16), InputError);
}

}  // namespace
}  // namespace fpkcheck::exact
