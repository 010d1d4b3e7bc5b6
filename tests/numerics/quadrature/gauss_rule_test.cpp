#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "numerics/quadrature/gauss_rule.hpp"

namespace fpkcheck::numerics {
namespace {

// Highest degree of the closures: degree of a term of (22) times a projection, at order 12.
constexpr int kDegree = 5 * 12 - 4;
constexpr double kRelative = 1e-12;

double apply(const QuadratureRule& rule, const std::function<double(double)>& g) {
  double sum = 0;
  for (std::size_t i = 0; i < rule.points.size(); ++i) sum += rule.weights[i] * g(rule.points[i]);
  return sum;
}

double power_average(const QuadratureRule& rule, int power) {
  return apply(rule, [&](double u) { return std::pow(u, power); });
}

// E|u|^power = 2^(power/2) Gamma((power+1)/2) / sqrt(pi).
double absolute_moment(int power) {
  return std::pow(2.0, power / 2.0) * std::tgamma((power + 1) / 2.0) / std::sqrt(std::numbers::pi);
}

void expect_relative(double value, double expected, int power) {
  EXPECT_NEAR(value / expected, 1.0, kRelative) << "power " << power;
}

TEST(GaussRules, NormalRuleGivesEveryMomentUpToItsDegree) {
  for (const int degree : {2, 6, 17, kDegree}) {
    const QuadratureRule rule = gauss_hermite_rule(degree);
    for (int power = 0; power <= degree; power += 2) {
      expect_relative(power_average(rule, power), absolute_moment(power), power);
    }
    EXPECT_NEAR(power_average(rule, 1), 0.0, 1e-14);
    EXPECT_NEAR(power_average(rule, 3), 0.0, 1e-13);
  }
}

TEST(GaussRules, SignRuleGivesTheOddAbsoluteMoments) {
  for (const int degree : {1, 5, 6, kDegree}) {
    const QuadratureRule rule = normal_rule_weighted_by_sign(degree);
    for (int power = 1; power <= degree; power += 2) {
      expect_relative(power_average(rule, power), absolute_moment(power), power);
    }
    EXPECT_NEAR(power_average(rule, 0), 0.0, 1e-14);
    EXPECT_NEAR(power_average(rule, 2), 0.0, 1e-13);
  }
}

TEST(GaussRules, AbsoluteRuleGivesTheEvenPowersTimesTheAbsoluteValue) {
  for (const int degree : {1, 4, 7, kDegree}) {
    const QuadratureRule rule = normal_rule_weighted_by_abs(degree);
    for (int power = 0; power <= degree; power += 2) {
      expect_relative(power_average(rule, power), absolute_moment(power + 1), power);
    }
    EXPECT_NEAR(power_average(rule, 1), 0.0, 1e-14);
    EXPECT_NEAR(power_average(rule, 3), 0.0, 1e-13);
  }
}

TEST(GaussRules, LegendreRuleIntegratesPolynomialsUpToDegree2NMinus1) {
  for (const int points : {1, 2, 9, 64}) {
    const QuadratureRule rule = gauss_legendre_rule(points, -1, 3);
    EXPECT_TRUE(std::ranges::is_sorted(rule.points));
    for (const int power : {0, 1, 2 * points - 2, 2 * points - 1}) {
      // int_{-1}^3 ((x - 1) / 2)^power dx, and with a factor that removes the symmetry
      const double integral = apply(rule, [&](double x) { return std::pow((x - 1) / 2, power); });
      EXPECT_NEAR(integral, power % 2 == 0 ? 4.0 / (power + 1) : 0, 1e-13)
          << points << ' ' << power;
    }
  }
  const double beyond =
      apply(gauss_legendre_rule(3, -1, 1), [](double x) { return std::pow(x, 6); });
  EXPECT_GT(std::abs(beyond - 2.0 / 7), 1e-2);
}

// Breaks of splines contain equal values.
TEST(GaussRules, CompositeRuleHasNoPointsBetweenEqualEnds) {
  const std::vector<double> ends{-1, 0, 0, 0, 2};
  const QuadratureRule rule = composite_gauss_rule<3>(ends);
  ASSERT_EQ(rule.weights.size(), static_cast<Eigen::Index>(rule.points.size()));
  EXPECT_EQ(rule.size(), 6);
  EXPECT_NEAR(rule.weights.dot(rule.quadrature_points_as_vector().array().pow(5).matrix()),
              63.0 / 6, 1e-13);
}

TEST(GaussRules, ExponentialRuleGivesTheFactorials) {
  for (const int degree : {1, 6, 25}) {
    const QuadratureRule rule = gauss_laguerre_rule(degree);
    for (int power = 0; power <= degree; ++power)
      expect_relative(power_average(rule, power), std::tgamma(power + 1.0), power);
  }
}

TEST(GaussRules, TooLowADegreeIsNotExact) {
  EXPECT_GT(std::abs(power_average(gauss_hermite_rule(4), 6) - absolute_moment(6)), 1.0);
  EXPECT_GT(std::abs(power_average(normal_rule_weighted_by_sign(3), 5) - absolute_moment(5)), 1.0);
  EXPECT_GT(std::abs(power_average(normal_rule_weighted_by_abs(2), 4) - absolute_moment(5)), 1.0);
}

}  // namespace
}  // namespace fpkcheck::numerics
