#include <gtest/gtest.h>

#include <cmath>

#include "epc/form/exponent_polynomial.hpp"
#include "scaled_polynomials.hpp"

namespace fpkcheck::epc {
namespace {

const ExponentPolynomial kPolynomial(
    {{1, 0, 0.5}, {0, 1, -2}, {2, 0, 3}, {1, 1, -1}, {0, 3, 0.25}, {2, 1, 4}});

double expected_value(double x, double y) {
  return 0.5 * x - 2 * y + 3 * x * x - x * y + 0.25 * y * y * y + 4 * x * x * y;
}

TEST(Polynomial, ValueIsTheSumOfItsTerms) {
  EXPECT_EQ(kPolynomial.degree(), 3);
  EXPECT_NEAR(kPolynomial(0.7, -1.3), expected_value(0.7, -1.3), 1e-14);
  EXPECT_EQ(kPolynomial(0, 0), 0);
}

TEST(Polynomial, AlongADirectionIsAPolynomialOfTheRadius) {
  const auto ray = kPolynomial.coefficients_along_ray(0.6, -0.8);
  ASSERT_EQ(ray.size(), 4u);
  for (const double rho : {0.0, 0.5, 2.0}) {
    EXPECT_NEAR(evaluate_polynomial(ray, rho), expected_value(0.6 * rho, -0.8 * rho), 1e-13);
  }
  EXPECT_NEAR(evaluate_polynomial(derivative_coefficients(ray), 1.5),
              (evaluate_polynomial(ray, 1.5 + 1e-5) - evaluate_polynomial(ray, 1.5 - 1e-5)) / 2e-5,
              1e-8);
}

using tests::kSigma;
using tests::radial_quartic_polynomial;
using tests::scaled_polynomial;

TEST(LeadingForm, OfAGaussianIsNegative) {
  const ExponentBehaviourAtInfinity form = leading_form(radial_quartic_polynomial(0), kSigma);
  EXPECT_TRUE(form.negative);
  EXPECT_EQ(form.rising_fraction, 0);
}

TEST(LeadingForm, MayVanishWhereALowerDegreeFalls) {
  EXPECT_TRUE(
      leading_form(scaled_polynomial({{2, 0, -1}, {0, 2, -1}, {4, 0, -0.3}}), kSigma).negative);
  EXPECT_FALSE(
      leading_form(scaled_polynomial({{2, 0, -1}, {0, 2, 1}, {4, 0, -0.3}}), kSigma).negative);
}

TEST(LeadingForm, IgnoresCoefficientsThatAreRounding) {
  EXPECT_TRUE(
      leading_form(scaled_polynomial({{2, 0, -1}, {0, 2, -1}, {4, 0, -0.3}, {6, 0, 1e-14}}), kSigma)
          .negative);
}

TEST(LeadingForm, NamesTheWorstDirectionAndTheRadius) {
  const ExponentBehaviourAtInfinity form = leading_form(
      scaled_polynomial({{2, 0, -0.5}, {0, 2, -0.5}, {4, 0, 1.0 / 64}, {2, 2, -1}, {0, 4, -0.1}}),
      kSigma);
  EXPECT_FALSE(form.negative);
  EXPECT_NEAR(std::abs(form.worst.x1), 1, 1e-12);
  EXPECT_NEAR(form.rises_from, 4, 0.02);
  EXPECT_GT(form.rising_fraction, 0);
  EXPECT_LT(form.rising_fraction, 0.2);
  EXPECT_EQ(leading_form(radial_quartic_polynomial(0.01), kSigma).rising_fraction, 1);
}

TEST(LeadingForm, DetectsAnOddLeadingDegree) {
  const ExponentBehaviourAtInfinity form =
      leading_form(scaled_polynomial({{2, 0, -1}, {0, 2, -1}, {0, 3, 0.1}}), kSigma);
  EXPECT_FALSE(form.negative);
  EXPECT_NEAR(form.worst.x2, 1, 1e-12);
  EXPECT_NEAR(form.rising_fraction, 0.5, 1e-2);
}

TEST(LeadingForm, IsDescribedInText) {
  EXPECT_EQ(
      describe_exponent_at_infinity(leading_form(radial_quartic_polynomial(0), kSigma), "(u, w)"),
      "although Q_n falls at infinity");
  EXPECT_EQ(
      describe_exponent_at_infinity(
          {.negative = false, .worst = {1, 0}, .rises_from = 4.017, .rising_fraction = 0.124},
          "(u, w)"),
      "and Q_n rises at infinity along 12 % of all directions, most steeply along (u, w) = (1.00, "
      "0.00) from radius 4.02 on");
}

}  // namespace
}  // namespace fpkcheck::epc
