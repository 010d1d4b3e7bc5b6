#include "approximations/cumulant/gram_charlier.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "approximations/cumulant/bivariate_polynomial.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "numerics/statistics.hpp"

namespace fpkcheck::cumulant {
namespace {

using Eigen::MatrixXd;

// Moments of an exponential variable, n!, whose cumulants are (n-1)!, and of the sum y = a + b,
// v = b of independent exponential variables a and b.
TEST(MomentsFromCumulants, AreThoseOfExponentialVariables) {
  MatrixXd cumulants = MatrixXd::Zero(7, 7);
  for (int p = 0; p <= 6; ++p) {
    for (int q = 0; p + q <= 6; ++q) {
      if (p + q == 0) continue;
      cumulants(p, q) = std::tgamma(p + q);
      if (q == 0) cumulants(p, 0) *= 2;
    }
  }
  const MatrixXd moments = moments_from_cumulants(cumulants, 6);
  EXPECT_DOUBLE_EQ(moments(0, 6), 720);
  // E[(a + b)^2 b^3] = 2 * 3! + 2 * 1 * 4! + 5!
  EXPECT_DOUBLE_EQ(moments(2, 3), 180);
  EXPECT_DOUBLE_EQ(moments(4, 0), 120);  // fourth moment of a gamma variable of shape 2
}

TEST(MomentsFromCumulants, NeglectHigherCumulants) {
  MatrixXd gaussian = MatrixXd::Zero(3, 3);
  gaussian(2, 0) = gaussian(0, 2) = 1;
  gaussian(1, 0) = 2;
  const MatrixXd moments = moments_from_cumulants(gaussian, 8);
  EXPECT_DOUBLE_EQ(moments(2, 6), 5 * 15);
  EXPECT_DOUBLE_EQ(moments(4, 2), 16 + 6 * 4 + 3);
}

MatrixXd standardised_moments() {
  MatrixXd cumulants = MatrixXd::Zero(7, 7);
  cumulants(2, 0) = cumulants(0, 2) = 1;
  cumulants(4, 0) = 0.8;
  cumulants(2, 2) = 0.3;
  cumulants(1, 3) = -0.2;
  cumulants(0, 4) = 0.5;
  cumulants(6, 0) = 1;
  cumulants(3, 3) = 0.4;
  return moments_from_cumulants(cumulants, 6);
}

double integrate(const MatrixXd& polynomial, double x_low, int a, int b) {
  constexpr double kLimit = 14;
  constexpr int kPanels = 16;
  return numerics::integrate_by_composite_gauss(
      [&](double x) {
        return numerics::integrate_by_composite_gauss(
            [&](double w) {
              return std::pow(x, a) * std::pow(w, b) * evaluate_polynomial(polynomial, x, w) *
                     numerics::normal_density(x) * numerics::normal_density(w);
            },
            -kLimit, kLimit, kPanels);
      },
      x_low, kLimit, kPanels);
}

TEST(GramCharlier, HasTheMomentsOfItsOrder) {
  const MatrixXd moments = standardised_moments();
  const MatrixXd polynomial = gram_charlier_polynomial(moments, 6);
  for (int a = 0; a <= 6; ++a) {
    for (int b = 0; a + b <= 6; ++b) {
      EXPECT_NEAR(integrate(polynomial, -14, a, b), moments(a, b), 1e-10) << a << ' ' << b;
    }
  }
}

TEST(GramCharlier, HasMomentsOfTheHalfPlane) {
  const MatrixXd polynomial = gram_charlier_polynomial(standardised_moments(), 6);
  for (const auto& [a, b] : {std::pair{1, 0}, {0, 1}, {3, 2}, {2, 3}, {5, 4}}) {
    EXPECT_NEAR(half_plane_moment(polynomial, a, b), 2 * integrate(polynomial, 0, a, b), 1e-9)
        << a << ' ' << b;
  }
}

}  // namespace
}  // namespace fpkcheck::cumulant
