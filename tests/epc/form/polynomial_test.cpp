#include "epc/form/polynomial.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::epc {
namespace {

const Polynomial kPolynomial(
    {{1, 0, 0.5}, {0, 1, -2}, {2, 0, 3}, {1, 1, -1}, {0, 3, 0.25}, {2, 1, 4}});

double by_hand(double x, double y) {
  return 0.5 * x - 2 * y + 3 * x * x - x * y + 0.25 * y * y * y + 4 * x * x * y;
}

TEST(Polynomial, ValueIsTheSumOfItsTerms) {
  EXPECT_EQ(kPolynomial.degree(), 3);
  EXPECT_NEAR(kPolynomial(0.7, -1.3), by_hand(0.7, -1.3), 1e-14);
  EXPECT_EQ(kPolynomial(0, 0), 0);
}

TEST(Polynomial, AlongADirectionIsAPolynomialOfTheRadius) {
  const auto ray = kPolynomial.restriction_to_ray(0.6, -0.8);
  ASSERT_EQ(ray.size(), 4u);
  for (const double rho : {0.0, 0.5, 2.0}) {
    EXPECT_NEAR(horner(ray, rho), by_hand(0.6 * rho, -0.8 * rho), 1e-13);
  }
  EXPECT_NEAR(horner(derivative_coefficients(ray), 1.5),
              (horner(ray, 1.5 + 1e-5) - horner(ray, 1.5 - 1e-5)) / 2e-5, 1e-8);
}

}  // namespace
}  // namespace fpkcheck::epc
