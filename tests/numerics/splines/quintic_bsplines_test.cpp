#include "numerics/splines/quintic_bsplines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fpkcheck::numerics {
namespace {

const QuinticBSplines& splines() {
  static const QuinticBSplines s(graded_knots(-5, 5, 2, 28, 3));
  return s;
}

double combined(const QuinticBSplines& s, const std::vector<double>& c, double x, bool slope) {
  const auto at = s.values_and_slopes(x);
  double sum = 0;
  for (int l = 0; l <= QuinticBSplines::kDegree; ++l) {
    sum += c[at.first + l] * (slope ? at.slope[l] : at.value[l]);
  }
  return sum;
}

TEST(QuinticBSplines, ReproducePowersAndTheirSlopes) {
  for (int p = 0; p <= 5; ++p) {
    const auto c = splines().coefficients_of_monomial(p);
    for (const double x : {-5.0, -3.3, -0.01, 0.0, 0.4, 1.999, 4.2, 5.0}) {
      EXPECT_NEAR(combined(splines(), c, x, false), std::pow(x, p), 1e-11 * std::pow(5, p));
      const double slope = p == 0 ? 0 : p * std::pow(x, p - 1);
      EXPECT_NEAR(combined(splines(), c, x, true), slope, 1e-11 * std::pow(5, p)) << p << ' ' << x;
    }
  }
}

TEST(QuinticBSplines, HaveTheCurvaturesOfPowers) {
  const auto curvature = [](int p, double x) {
    const auto c = splines().coefficients_of_monomial(p);
    const auto at = splines().second_derivatives(x);
    double sum = 0;
    for (int l = 0; l <= QuinticBSplines::kDegree; ++l)
      sum += c[splines().values_and_slopes(x).first + l] * at[l];
    return sum;
  };
  for (int p = 0; p <= 5; ++p) {
    for (const double x : {-5.0, -3.3, -0.01, 0.0, 0.4, 1.999, 4.2, 5.0}) {
      const double exact = p < 2 ? 0 : p * (p - 1) * std::pow(x, p - 2);
      EXPECT_NEAR(curvature(p, x), exact, 1e-10 * std::pow(5, p)) << p << ' ' << x;
    }
    EXPECT_EQ(curvature(p, 5.1), 0);
  }
}

TEST(QuinticBSplines, AreContinuedAsConstants) {
  const auto c = splines().coefficients_of_monomial(1);
  EXPECT_NEAR(combined(splines(), c, 7, false), 5, 1e-13);
  EXPECT_EQ(combined(splines(), c, 7, true), 0);
  EXPECT_NEAR(combined(splines(), c, -9, false), -5, 1e-13);
}

TEST(QuinticBSplines, HaveACornerInTheSecondSlopeAtATripleKnot) {
  // The first two derivatives are continuous at the triple knot; the third derivative is not.
  std::vector<double> c(static_cast<std::size_t>(splines().size()), 0.0);
  c[static_cast<std::size_t>(splines().size()) / 2] = 1;
  const double h = 1e-3;
  const auto slope = [&](double x) { return combined(splines(), c, x, true); };
  const double right = (slope(2 * h) - 2 * slope(h) + slope(0)) / (h * h);
  const double left = (slope(0) - 2 * slope(-h) + slope(-2 * h)) / (h * h);
  const double bend_right = (slope(h) - slope(0)) / h, bend_left = (slope(0) - slope(-h)) / h;
  EXPECT_NEAR(bend_right, bend_left, 3 * h * std::max(std::abs(right), std::abs(left)));
  EXPECT_GT(std::abs(right - left), 0.1 * std::abs(right));
}

TEST(GradedKnots, AreEvenInTheMiddleAndWidenOutwards) {
  const auto& breaks = splines().breaks();
  EXPECT_EQ(breaks.size(), 29u);
  EXPECT_EQ(breaks.front(), -5);
  EXPECT_EQ(breaks.back(), 5);
  EXPECT_EQ(std::count(splines().knots().begin(), splines().knots().end(), 0.0), 3);
  for (std::size_t k = 15; k + 1 < breaks.size(); ++k) {
    const double before = breaks[k] - breaks[k - 1], after = breaks[k + 1] - breaks[k];
    if (breaks[k + 1] < 2.001) {
      EXPECT_NEAR(after, before, 1e-12);
    } else {
      EXPECT_GT(after, 1.01 * before);
    }
    EXPECT_EQ(breaks[28 - k], -breaks[k]);
  }
}

TEST(GradedKnots, ShrinkTowardsZeroWhereAsked) {
  const QuinticBSplines fine(graded_knots(-5, 5, 2, 40, 3, 6));
  const auto& breaks = fine.breaks();
  ASSERT_EQ(breaks.size(), 41u);
  EXPECT_EQ(breaks.back(), 5);
  EXPECT_EQ(std::count(fine.knots().begin(), fine.knots().end(), 0.0), 3);
  const auto width = [&](std::size_t k) { return breaks[21 + k] - breaks[20 + k]; };
  for (std::size_t k = 0; k < 20; ++k) {
    EXPECT_EQ(breaks[20 - k], -breaks[20 + k]);
    if (k < 6) {
      EXPECT_NEAR(width(k + 1) / width(k), 1.25, 1e-12);
    } else if (k < 17) {
      EXPECT_NEAR(width(k), width(6), 1e-14);
    }
  }
  EXPECT_NEAR(breaks[38], 2, 1e-14);  // two of twenty cells widen
  const QuinticBSplines half(graded_knots(0, 5, 2, 20, 1, 6));
  EXPECT_EQ(half.breaks(), std::vector<double>(breaks.begin() + 20, breaks.end()));
}

}  // namespace
}  // namespace fpkcheck::numerics
