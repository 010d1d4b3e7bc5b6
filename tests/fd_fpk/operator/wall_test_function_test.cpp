#include "fd_fpk/operator/wall_test_function.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>

#include "problem/problem_features.hpp"

namespace fpkcheck::fd_fpk {
namespace {

constexpr double kDiffusion = 0.7, kForce = 1.3, kRestitution = 0.4;

// f_v = phi'(s) / (D y)^(1/3) by its integral, without the table; t = s + x.
TEST(WallTestFunction, HasTheSlopeOfItsIntegral) {
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;
  const WallTestFunction f(kDiffusion, 0, kRestitution);
  for (const double s : {-20.0, -3.0, -0.5, 0.0, 1.0, 5.0, 13.9, 14.1}) {
    const auto integrand = [&](double x) {
      return (s + x) / 3 * std::exp(-x * (3 * s * s + 3 * s * x + x * x) / 9);
    };
    const double slope = Quadrature::integrate(integrand, 0.0, 60.0, 15, 1e-13);
    EXPECT_NEAR(f.velocity_derivative(1 / kDiffusion, s), slope, 1e-9) << s;
  }
}

// D h_vv + v h_y = F_0 f_v, by central differences.
TEST(WallTestFunction, SolvesItsEquation) {
  const WallTestFunction h(kDiffusion, kForce, kRestitution), f(kDiffusion, 0, kRestitution);
  constexpr double kStep = 1e-3;
  for (const double y : {0.3, 2.0}) {
    for (const double v : {-20.0, -3.0, -0.4, 0.0, 0.7, 4.0, 20.0}) {
      const double h_vv =
          (h.velocity_derivative(y, v + kStep) - h.velocity_derivative(y, v - kStep)) / (2 * kStep);
      const double h_y = (h(y + kStep * y, v) - h(y - kStep * y, v)) / (2 * kStep * y);
      EXPECT_NEAR(kDiffusion * h_vv + v * h_y, kForce * f.velocity_derivative(y, v), 2e-6)
          << y << " " << v;
      const double h_v = (h(y, v + kStep) - h(y, v - kStep)) / (2 * kStep);
      EXPECT_NEAR(h_v, h.velocity_derivative(y, v), 1e-6) << y << " " << v;
      const double force = 2.1;
      EXPECT_NEAR(h.backward_equation_remainder(y, v, force),
                  force * h.velocity_derivative(y, v) - kForce * f.velocity_derivative(y, v),
                  1e-12);
    }
  }
}

// For any speed, and by zero where impacts accumulate.
TEST(WallTestFunction, EveryImpactRaisesItByTheSameAmount) {
  constexpr double kNextToWall = 1e-33;
  for (const double r : {0.2, 0.5, 0.9}) {
    const WallTestFunction h(kDiffusion, kForce, r);
    for (const double u : {1e-3, 1.0, 40.0}) {
      EXPECT_NEAR(h(kNextToWall, r * u) - h(kNextToWall, -u),
                  WallTestFunction::kStepAtWall + std::log(r), 1e-9)
          << r << " " << u;
    }
  }
  EXPECT_NEAR(WallTestFunction::kStepAtWall + std::log(problem::kCollapseRestitution), 0, 1e-14);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
