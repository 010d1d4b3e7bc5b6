#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "epc/amplitude/impulse_means.hpp"
#include "trapezoid.hpp"

namespace fpkcheck::epc::amplitude {
namespace {

class EachLaw : public testing::TestWithParam<const char*> {
 protected:
  problem::ImpulseLaw law = problem::ImpulseLaw::from_name(GetParam(), 0.2, 0.5);
};
INSTANTIATE_TEST_SUITE_P(Law, EachLaw,
                         testing::Values("gaussian", "laplace", "two_point", "uniform"));

TEST_P(EachLaw, TakesTheMeanOfPolynomialsOfTheVelocity) {
  GradedImpulseQuadrature rule(law);
  for (const double v : {-1.3, 0.0, 0.4}) {
    for (const double width : {1e-5, 0.1, 3.0}) {
      const auto& [after, probability] = rule(v, width);
      double sum[3] = {};
      for (std::size_t i = 0; i < after.size(); ++i) {
        for (int j = 0; j < 3; ++j) sum[j] += probability[i] * std::pow(after[i], j);
      }
      EXPECT_NEAR(sum[0], 1, 1e-9) << v << " " << width;
      EXPECT_NEAR(sum[1], v + 0.2, 1e-9) << v << " " << width;
      EXPECT_NEAR(sum[2], v * v + 2 * v * 0.2 + 0.25 + 0.04, 1e-9) << v << " " << width;
    }
  }
}

// At the wall theta is a step function: its mean is pi/2 (P(Y > -v) - P(Y < -v)).
TEST(GradedImpulseQuadrature, IntegratesTheStepOfThePhaseAtTheWall) {
  const auto law = problem::ImpulseLaw::from_name("gaussian", 0, 0.5);
  GradedImpulseQuadrature rule(law);
  for (const double v : {-0.7, -0.01, 0.3}) {
    for (const double width : {1e-10, 1e-8}) {
      const auto& [after, probability] = rule(v, width);
      double mean = 0;
      for (std::size_t i = 0; i < after.size(); ++i) {
        mean += probability[i] * std::atan2(after[i], width);
      }
      EXPECT_NEAR(mean, M_PI / 2 * std::erf(v / 0.5 / std::sqrt(2.0)), 1e-7) << v;
    }
  }
}

// The phase is a steep but continuous function of the velocity.
TEST(GradedImpulseQuadrature, ResolvesASteepPhase) {
  const auto law = problem::ImpulseLaw::from_name("laplace", 0, 0.5);
  GradedImpulseQuadrature rule(law);
  for (const double width : {0.003, 0.05, 0.4}) {
    const auto& [after, probability] = rule(0.2, width);
    double mean = 0, amplitude = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
      mean += probability[i] * std::pow(std::atan2(after[i], width), 3);
      amplitude += probability[i] * std::hypot(after[i], width);
    }
    // v + Y = width sinh(s): the integrand is smooth in s but for the kink of the law at Y = 0.
    const auto integral = [&](const auto& f) {
      const auto integrand = [&](double s) {
        const double u = width * std::sinh(s);
        return law.density(u - 0.2) * f(u) * width * std::cosh(s);
      };
      const double kink = std::asinh(0.2 / width), end = std::asinh(16 / width);
      return tests::trapezoid(integrand, -end, kink, 200000) +
             tests::trapezoid(integrand, kink, end, 200000);
    };
    EXPECT_NEAR(mean, integral([&](double u) { return std::pow(std::atan2(u, width), 3); }), 1e-7);
    EXPECT_NEAR(amplitude, integral([&](double u) { return std::hypot(u, width); }), 1e-7);
  }
}

}  // namespace
}  // namespace fpkcheck::epc::amplitude
