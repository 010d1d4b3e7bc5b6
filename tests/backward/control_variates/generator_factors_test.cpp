#include <gtest/gtest.h>

#include <cmath>

#include "backward/control_variates/generator_factors.hpp"
#include "laws.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::backward {
namespace {

const numerics::QuinticBSplines& wide_splines() {
  static const numerics::QuinticBSplines s(numerics::graded_knots(-30, 30, 3, 60, 3));
  return s;
}

TEST(ImpulseMeans, AreTheMomentsOfEveryLawOnPowers) {
  const double v[] = {-1.3, 0, 0.05, 2.0};
  for (const std::string& name : tests::law_names_without_table()) {
    for (const double mean : {0.0, 0.2}) {
      const auto law = problem::ImpulseLaw::from_name(name, mean, 0.4);
      const Eigen::MatrixXd k = spline_means_after_impulse(wide_splines(), law, v);
      for (int p = 0; p <= 5; ++p) {
        const auto c = wide_splines().coefficients_of_monomial(p);
        const Eigen::VectorXd got =
            k * Eigen::Map<const Eigen::VectorXd>(c.data(), wide_splines().size());
        for (int i = 0; i < 4; ++i) {
          double expected = 0, choose = 1;  // sum of binomials v^(p-n) E[Y^n]
          for (int n = 0; n <= p; ++n) {
            expected += choose * std::pow(v[i], p - n) * law.moment(n);
            choose = choose * (p - n) / (n + 1);
          }
          // The pieces of the Laplace law omit a probability of 1e-18, here times 30^5.
          EXPECT_NEAR(got(i), expected, 1e-10) << name << ' ' << mean << ' ' << p;
        }
      }
    }
  }
}

TEST(ImpulseMeans, SumToOneEverywhere) {
  const double v[] = {-40, -30, -29.9, 0, 30, 33};
  for (const std::string& name : tests::law_names_without_table()) {
    const auto law = problem::ImpulseLaw::from_name(name, 0.1, 2.0);
    const Eigen::MatrixXd k = spline_means_after_impulse(wide_splines(), law, v);
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(k.row(i).sum(), 1, 1e-13) << name << ' ' << v[i];
  }
}

TEST(ImpulseMeans, OfTwoPointsAreTwoShifts) {
  const double v[] = {0.37};
  const Eigen::MatrixXd k = spline_means_after_impulse(
      wide_splines(), problem::ImpulseLaw::from_name("two_point", 0, 0.5), v);
  for (int j = 0; j < wide_splines().size(); ++j) {
    double expected = 0;
    for (const double at : {0.37 - 0.5, 0.37 + 0.5}) {
      const auto b = wide_splines().values_and_slopes(at);
      if (j >= b.first && j <= b.first + 5) expected += 0.5 * b.value[j - b.first];
    }
    EXPECT_NEAR(k(0, j), expected, 1e-15);
  }
}

TEST(ImpulseMeans, OfAUniformLawAreAveragesOverCorners) {
  // The triple knot at 0 lies inside the support; the expected values are from a fine midpoint
  // rule.
  const double v[] = {0.2};
  const auto law = problem::ImpulseLaw::from_name("uniform", 0, 0.5);
  const double half = 0.5 * std::sqrt(3.0);
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(wide_splines().size());
  constexpr int kPoints = 20000;
  for (int n = 0; n < kPoints; ++n) {
    const auto b = wide_splines().values_and_slopes(0.2 - half + 2 * half * (n + 0.5) / kPoints);
    for (int l = 0; l <= 5; ++l) expected(b.first + l) += b.value[l] / kPoints;
  }
  EXPECT_LT((spline_means_after_impulse(wide_splines(), law, v).row(0).transpose() - expected)
                .cwiseAbs()
                .maxCoeff(),
            1e-7);
}

// The cells between these speeds are those of the impact fluxes of a density.
TEST(ImpactSpeeds, IncreaseStrictlyForEveryRestitution) {
  for (const double r : {0.5, 0.9, 1.0}) {
    for (const double sign : {1.0, -1.0}) {
      const auto speeds = impact_speed_breaks(wide_splines(), {0, r, sign});
      ASSERT_GT(speeds.size(), 20u);
      EXPECT_EQ(speeds.front(), 0);
      for (std::size_t n = 1; n < speeds.size(); ++n) EXPECT_GT(speeds[n], speeds[n - 1]);
    }
  }
}

}  // namespace
}  // namespace fpkcheck::backward
