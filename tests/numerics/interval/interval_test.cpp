#include "numerics/interval/interval.hpp"

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

#include <cmath>
#include <random>
#include <vector>

namespace fpkcheck::numerics {
namespace {

using Exact = boost::multiprecision::cpp_rational;
using Precise = boost::multiprecision::cpp_bin_float_100;

// Doubles of many magnitudes and both signs, with inexact products and quotients.
std::vector<double> awkward_numbers(int count) {
  std::mt19937_64 random(20240713);
  std::uniform_real_distribution<double> mantissa(1, 2);
  std::uniform_int_distribution<int> exponent(-60, 60), sign(0, 1);
  std::vector<double> numbers{0.1, 1.0 / 3, -0.7, 0x1p-30, 1e16, -1e16, 1 + 0x1p-52};
  while (static_cast<int>(numbers.size()) < count) {
    numbers.push_back(std::ldexp(mantissa(random), exponent(random)) * (2 * sign(random) - 1));
  }
  return numbers;
}

// The interval contains the exact result, is at most one unit in the last place wide, and is a
// point only for an exact result. Arithmetic rounded to nearest, or in one direction only, fails.
void expect_tight(const Interval& result, const Exact& exact, const char* what) {
  ASSERT_LE(Exact(result.lower()), exact) << what;
  ASSERT_GE(Exact(result.upper()), exact) << what;
  ASSERT_LE(result.upper(), std::nextafter(result.lower(), HUGE_VAL)) << what;
  if (Exact(result.lower()) != exact) {
    ASSERT_LT(result.lower(), result.upper()) << what;
  }
}

TEST(Interval, EveryOperationEnclosesTheExactResultAndNoMore) {
  const std::vector<double> numbers = awkward_numbers(120);
  for (const double a : numbers) {
    for (const double b : numbers) {
      struct {
        Interval sum, difference, product, quotient;
      } r{};
      call_with_upward_rounding([&] {
        const Interval x = a, y = b;
        r = {x + y, x - y, x * y, x / y};
        return 0;
      });
      expect_tight(r.sum, Exact(a) + Exact(b), "sum");
      expect_tight(r.difference, Exact(a) - Exact(b), "difference");
      expect_tight(r.product, Exact(a) * Exact(b), "product");
      expect_tight(r.quotient, Exact(a) / Exact(b), "quotient");
    }
  }
}

TEST(Interval, ProductsOfIntervalsHoldAllProductsOfTheirEnds) {
  const std::vector<double> numbers = awkward_numbers(24);
  for (const double a : numbers) {
    for (const double b : numbers) {
      for (const double c : numbers) {
        const Interval x(std::min(a, b), std::max(a, b));
        const Interval product = call_with_upward_rounding([&] { return x * Interval(c) + x; });
        for (const double end : {a, b}) {
          const Exact exact = Exact(end) * Exact(c) + Exact(end);
          EXPECT_LE(Exact(product.lower()), exact);
          EXPECT_GE(Exact(product.upper()), exact);
        }
      }
    }
  }
}

TEST(Interval, ASumWhoseTermsCancelStillHoldsTheExactOne) {
  const std::vector<double> numbers = awkward_numbers(200);
  Exact exact = 0;
  for (const double x : numbers) exact += Exact(x) * Exact(x) - Exact(0.1) * Exact(x);
  for (const double x : numbers) exact -= Exact(x) * Exact(x);
  const Interval sum = call_with_upward_rounding([&] {
    Interval s = 0;
    for (const double x : numbers) s += Interval(x) * x - Interval(0.1) * x;
    for (const double x : numbers) s -= Interval(x) * x;
    return s;
  });
  EXPECT_LE(Exact(sum.lower()), exact);
  EXPECT_GE(Exact(sum.upper()), exact);
}

TEST(Interval, EnclosesRootsAndExponentials) {
  for (const double x : {1e-9, 0.1, 0.24, 0.26, 1.0, 2.0 / 3, 7.7, 40.5, 123.4}) {
    const auto [root, decay] = call_with_upward_rounding(
        [&] { return std::pair(sqrt(Interval(x)), exponential(Interval(-x))); });
    const Precise e = exp(-Precise(x)), s = sqrt(Precise(x));
    EXPECT_LE(Precise(root.lower()), s) << x;
    EXPECT_GE(Precise(root.upper()), s) << x;
    EXPECT_LE(Precise(decay.lower()), e) << x;
    EXPECT_GE(Precise(decay.upper()), e) << x;
    EXPECT_LT(width(decay), 1e-12 * decay.upper()) << x;
  }
}

TEST(Interval, RootsAreEnclosedWhateverTheirLastBit) {
  for (const double a : awkward_numbers(400)) {
    const double x = std::abs(a);
    const Interval root = call_with_upward_rounding([&] { return sqrt(Interval(x)); });
    EXPECT_LE(Exact(root.lower()) * Exact(root.lower()), Exact(x));
    EXPECT_GE(Exact(root.upper()) * Exact(root.upper()), Exact(x));
    EXPECT_LE(root.upper() - root.lower(), 5e-16 * root.upper());
  }
}

TEST(Interval, RoundingIsUpwardInsideAndAsBeforeOutside) {
  const int before = std::fegetround();
  EXPECT_EQ(call_with_upward_rounding([] { return std::fegetround(); }), FE_UPWARD);
  EXPECT_EQ(std::fegetround(), before);
  EXPECT_THROW(
      call_with_upward_rounding([]() -> int { throw std::runtime_error("thrown inside"); }),
      std::runtime_error);
  EXPECT_EQ(std::fegetround(), before);
}

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
                                higher = elevate_bernstein_degree(b, 11);
    for (int k = 0; k < 4; ++k) expect_value(back[k], kPowers[k].lower());
    for (const double t : {0.0, 0.3, 0.77, 1.0}) {
      expect_value(evaluate_bernstein_polynomial(b, Interval(t)), cubic(t));
      expect_value(evaluate_bernstein_polynomial(higher, Interval(t)), cubic(t));
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
      expect_value(evaluate_bernstein_polynomial(p, Interval(t)), cubic(t) * (2 - 3 * t));
      expect_value(evaluate_bernstein_polynomial(d, Interval(t)), -3 + 4 * t + 15 * t * t);
    }
    return 0;
  });
}

TEST(Bernstein, APolynomialIsCarriedToASegment) {
  call_with_upward_rounding([] {
    const BernsteinCoefficients b = bernstein_coefficients_on_segment(
        std::array{1.0, -3.0, 2.0, 5.0}, Interval(0.5), Interval(1), Interval(3));
    for (const double t : {0.0, 0.25, 1.0}) {
      expect_value(evaluate_bernstein_polynomial(b, Interval(t)) / 100.0,
                   cubic(1 + 2 * t - 0.5) / 100);
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
