#include "approximations/cumulant/bivariate_polynomial.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::cumulant {
namespace {

constexpr Rectangle kRectangle{.x_low = -1, .x_high = 5, .w_low = -4, .w_high = 4};

TEST(PolynomialFit, FindsTheCoefficients) {
  const auto fit = fit_polynomial(
      [](double x, double w) { return 0.2 * w * (1 + x * x) - x + std::pow(x, 5) / 4; },
      kRectangle);
  ASSERT_TRUE(fit);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(7, 7);
  expected(0, 1) = expected(2, 1) = 0.2;
  expected(1, 0) = -1;
  expected(5, 0) = 0.25;
  EXPECT_LT((*fit - expected).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(PolynomialFit, RefusesOtherFunctions) {
  for (const auto f : {+[](double x, double) { return std::tanh(x); },
                       +[](double x, double w) { return x + w * std::abs(w); },
                       +[](double x, double) { return std::pow(x, 7); },
                       +[](double x, double) { return 1 / x; }}) {
    EXPECT_FALSE(fit_polynomial(f, kRectangle));
  }
}

TEST(PolynomialFit, AcceptsAFunctionWithoutKinksInTheRectangle) {
  const auto fit = fit_polynomial([](double x, double) { return std::abs(x + 2); }, kRectangle);
  ASSERT_TRUE(fit);
  EXPECT_NEAR((*fit)(0, 0), 2, 1e-10);
}

}  // namespace
}  // namespace fpkcheck::cumulant
