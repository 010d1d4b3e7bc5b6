#include "exact/linear_moments.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/input_error.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::exact {

using namespace problem;

namespace {

constexpr MeanAndCovariance kStart{.z = 0.4, .v = -0.7, .var_z = 0.3, .cov_zv = 0.1, .var_v = 0.2};

Problem linear(double damping, double mean = 0) {
  return tests::make_problem(
      {.damping = damping, .stiffness = 1.7, .cubic = 0, .restitution = 1, .mean = mean});
}

TEST(LinearMoments, BeginWithTheInitialMoments) {
  const auto m = linear_moments_at(linear(0.3), kStart, 0);
  EXPECT_DOUBLE_EQ(m.z, 0.4);
  EXPECT_DOUBLE_EQ(m.v, -0.7);
  EXPECT_DOUBLE_EQ(m.zz, 0.3 + 0.16);
  EXPECT_DOUBLE_EQ(m.zv, 0.1 - 0.28);
  EXPECT_DOUBLE_EQ(m.vv, 0.2 + 0.49);
}

TEST(LinearMoments, ObeyTheirDifferentialEquations) {
  for (const double c : {0.3, 2 * std::sqrt(1.7), 5.0}) {  // under-, critically and overdamped
    const Problem p = linear(c);
    const double k = p.system.stiffness();
    for (const double t : {0.5, 2.0}) {
      SCOPED_TRACE(t);
      constexpr double kStep = 1e-3;
      const auto at = [&](double time) { return linear_moments_at(p, kStart, time); };
      const auto m = at(t), next = at(t + kStep), last = at(t - kStep);
      const auto rate = [&](double LinearMoments::*moment) {
        return (next.*moment - last.*moment) / (2 * kStep);
      };
      // Error of central differences: step^2 / 6 times third derivatives, which are below 100 here.
      constexpr double kError = 2e-5;
      EXPECT_NEAR(rate(&LinearMoments::z), m.v, kError);
      EXPECT_NEAR(rate(&LinearMoments::v), -k * m.z - c * m.v, kError);
      EXPECT_NEAR(rate(&LinearMoments::zz), 2 * m.zv, kError);
      EXPECT_NEAR(rate(&LinearMoments::zv), m.vv - k * m.zz - c * m.zv, kError);
      EXPECT_NEAR(rate(&LinearMoments::vv), -2 * k * m.zv - 2 * c * m.vv + 0.1, kError);
    }
  }
}

TEST(LinearMoments, ConvergeToTheStationaryMoments) {
  const auto m = linear_moments_at(linear(0.3), kStart, 300);
  EXPECT_NEAR(m.z, 0, 1e-14);
  EXPECT_NEAR(m.v, 0, 1e-14);
  EXPECT_NEAR(m.zz, 0.1 / (2 * 0.3 * 1.7), 1e-14);
  EXPECT_NEAR(m.zv, 0, 1e-14);
  EXPECT_NEAR(m.vv, 0.1 / (2 * 0.3), 1e-14);
}

TEST(LinearMoments, InTimeAreThoseOfTheConstantExcitation) {
  const Problem p = linear(0.3);
  const auto closed = linear_moments_at(p, kStart, 2),
             integrated = linear_moments_in_time(p, kStart, 2);
  for (double LinearMoments::*moment : {&LinearMoments::z, &LinearMoments::v, &LinearMoments::zz,
                                        &LinearMoments::zv, &LinearMoments::vv}) {
    EXPECT_NEAR(integrated.*moment, closed.*moment, 1e-8);
  }
}

// The response to F = F_0 cos(w t) after the decay of the initial state.
TEST(LinearMoments, InTimeHaveTheResponseToAHarmonicForce) {
  Problem p = linear(0.3);
  p.time = ExcitationTimeDependence({.force = "0.4*cos(1.1*t)"}, {});
  const double t = 200, w = 1.1, k = 1.7, c = 0.3;
  const auto m = linear_moments_in_time(p, kStart, t);
  const double real = k - w * w, imaginary = c * w, square = real * real + imaginary * imaginary;
  EXPECT_NEAR(m.z, 0.4 * (real * std::cos(w * t) + imaginary * std::sin(w * t)) / square, 1e-7);
  EXPECT_NEAR(m.zz - m.z * m.z, 0.1 / (2 * c * k), 1e-7);
  EXPECT_NEAR(m.vv - m.v * m.v, 0.1 / (2 * c), 1e-7);
}

TEST(LinearMoments, RefuseOtherProblems) {
  EXPECT_THROW(linear_moments_at(tests::make_problem(), kStart, 1), InputError);
  EXPECT_THROW(linear_moments_at(linear(0.3, 0.1), kStart, 1), InputError);
  EXPECT_THROW(linear_moments_at(linear(0.3), kStart, -1), InputError);
}

}  // namespace
}  // namespace fpkcheck::exact
