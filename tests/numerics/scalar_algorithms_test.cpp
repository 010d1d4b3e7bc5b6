#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "numerics/chebyshev_interpolation.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "numerics/roots/bracketed_root.hpp"
#include "numerics/statistics.hpp"

namespace fpkcheck::numerics {
namespace {

double power_integral(double a, double b, int power) {
  return (std::pow(b, power + 1) - std::pow(a, power + 1)) / (power + 1);
}

template <unsigned N>
void expect_exact_up_to_degree() {
  for (int power = 0; power <= 2 * static_cast<int>(N) - 1; ++power) {
    const auto f = [&](double x) { return std::pow(x, power); };
    double sum = 0;
    const auto points = composite_gauss_points<N>(-1, 2, 3);
    for (const auto& [at, weight] : points) sum += weight * f(at);
    EXPECT_EQ(points.size(), 3 * N);
    EXPECT_NEAR(sum, power_integral(-1, 2, power), 1e-13 * power_integral(0, 2, power)) << N;
    const std::array ends{-1.0, 0.25, 2.0};
    const auto rule = composite_gauss_rule<N>(ends);
    sum = 0;
    for (std::size_t n = 0; n < rule.points.size(); ++n) {
      sum += rule.weights(static_cast<Eigen::Index>(n)) * f(rule.points[n]);
    }
    EXPECT_NEAR(sum, power_integral(-1, 2, power), 1e-13 * power_integral(0, 2, power)) << N;
  }
}

TEST(GaussRule, IntegratesPolynomialsUpToItsDegreeExactly) {
  expect_exact_up_to_degree<3>();
  expect_exact_up_to_degree<4>();
  expect_exact_up_to_degree<7>();
  expect_exact_up_to_degree<10>();
  for (int power = 0; power <= 5; ++power) {
    EXPECT_NEAR(gauss_legendre_average([&](double x) { return std::pow(x, power); }, -1, 2),
                power_integral(-1, 2, power) / 3, 1e-13);
  }
}

TEST(LagrangeWeights, ReproducePolynomialsOfADegreeBelowTheNumberOfNodes) {
  const std::vector<double> nodes{-1, -0.3, 0.5, 2};
  for (const double x : {-1.0, 0.1, 1.7, 3.0}) {
    const auto weights = lagrange_weights(nodes, x);
    for (int power = 0; power < 4; ++power) {
      double sum = 0;
      for (std::size_t n = 0; n < nodes.size(); ++n) sum += weights[n] * std::pow(nodes[n], power);
      EXPECT_NEAR(sum, std::pow(x, power), 1e-12) << x << " " << power;
    }
  }
}

TEST(LagrangeDerivativeWeights, DifferentiatePolynomialsOfADegreeBelowTheNumberOfNodes) {
  const std::vector<double> nodes{-1, 2, -0.3, 0.5, 0.9};
  for (const double x : {-1.0, 0.1, 2.5}) {
    for (int order = 0; order <= 3; ++order) {
      const auto weights = lagrange_derivative_weights(nodes, x, order);
      for (int power = 0; power < 5; ++power) {
        double sum = 0, exact = std::pow(x, power - order);
        for (std::size_t n = 0; n < nodes.size(); ++n)
          sum += weights[n] * std::pow(nodes[n], power);
        for (int k = 0; k < order; ++k) exact *= power - k;
        if (power < order) exact = 0;
        EXPECT_NEAR(sum, exact, 1e-11) << x << " " << order << " " << power;
      }
    }
  }
}

TEST(BracketedRoot, HasTheRequestedNumberOfBits) {
  EXPECT_NEAR(bracketed_root([](double x) { return x * x - 2; }, 0, 2), std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(bracketed_root([](double x) { return std::cos(x); }, 0, 3, 20), std::acos(0), 1e-5);
  EXPECT_EQ(bracketed_root([](double x) { return x; }, 0, 1), 0);
  EXPECT_EQ(bracketed_root([](double x) { return x - 1; }, 0, 1), 1);
}

TEST(Statistics, HaveTheMedianAndTheNormalQuantile) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 3);
  EXPECT_NEAR(std::erf(kNormal95 / std::sqrt(2.0)), 0.95, 1e-8);
}

TEST(NormalProbability, HasTheValuesOfTables) {
  EXPECT_DOUBLE_EQ(normal_probability(0), 0.5);
  EXPECT_NEAR(normal_probability(kNormal95), 0.975, 1e-8);
  EXPECT_NEAR(normal_probability(-3), 1.349898031630095e-3, 1e-15);
}

}  // namespace
}  // namespace fpkcheck::numerics
