#include "numerics/interval/bernstein.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::numerics {
namespace {

// The value of the polynomial 1 - 3 t + 2 t^2 + 5 t^3 at t.
double cubic(double t) { return 1 + t * (-3 + t * (2 + t * 5)); }
const BernsteinCoefficients kPowers{Interval(1), Interval(-3), Interval(2), Interval(5)};

void expect_value(const Interval& x, double expected) {
  EXPECT_NEAR(x.lower(), expected, 1e-13);
  EXPECT_NEAR(x.upper(), expected, 1e-13);
  EXPECT_LE(x.lower(), x.upper());
}

TEST(Bernstein, PowersAndBackAndOfAnyHigherDegree) {
  call_with_upward_rounding([] {
    const BernsteinCoefficients b = bernstein_from_power_coefficients(kPowers);
    const BernsteinCoefficients back = power_coefficients_from_bernstein(b),
                                higher = elevate_degree(b, 11);
    for (int k = 0; k < 4; ++k) expect_value(back[k], kPowers[k].lower());
    for (const double t : {0.0, 0.3, 0.77, 1.0}) {
      expect_value(bernstein_value(b, Interval(t)), cubic(t));
      expect_value(bernstein_value(higher, Interval(t)), cubic(t));
    }
    return 0;
  });
}

TEST(Bernstein, ProductsAndDerivativesAreThoseOfThePolynomials) {
  call_with_upward_rounding([] {
    const BernsteinCoefficients b = bernstein_from_power_coefficients(kPowers),
                                line{Interval(2), Interval(-1)};  // 2 - 3t
    const BernsteinCoefficients p = bernstein_product(b, line), d = bernstein_derivative(b);
    for (const double t : {0.1, 0.5, 0.9}) {
      expect_value(bernstein_value(p, Interval(t)), cubic(t) * (2 - 3 * t));
      expect_value(bernstein_value(d, Interval(t)), -3 + 4 * t + 15 * t * t);
    }
    return 0;
  });
}

TEST(Bernstein, APolynomialIsCarriedToASegment) {
  call_with_upward_rounding([] {
    const BernsteinCoefficients b = bernstein_on_segment(std::array{1.0, -3.0, 2.0, 5.0},
                                                         Interval(0.5), Interval(1), Interval(3));
    for (const double t : {0.0, 0.25, 1.0}) {
      expect_value(bernstein_value(b, Interval(t)) / 100.0, cubic(1 + 2 * t - 0.5) / 100);
    }
    return 0;
  });
}

TEST(Bernstein, BinomialCoefficientsAreExact) {
  EXPECT_EQ(binomial_coefficient(6, 3), 20);
  EXPECT_EQ(binomial_coefficient(24, 12), 2704156);
  EXPECT_EQ(binomial_coefficient(40, 20), 137846528820);
}

}  // namespace
}  // namespace fpkcheck::numerics
