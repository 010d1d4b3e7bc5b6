#include "epc/gaussian/gaussian_weighted_basis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "numerics/quadrature/gauss_rule.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

// Returns the values of all basis functions at one point.
Eigen::RowVectorXd basis_values_at_point(const GaussianWeightedBasis& basis, double x1, double x2) {
  return basis.basis_values(Eigen::VectorXd::Constant(1, x1), Eigen::VectorXd::Constant(1, x2));
}

TEST(Basis, HasTheNumberOfUnknownsOfThePaper) {
  // The number of monomials of degree 1 .. n is (n+1)(n+2)/2 - 1. About half of the monomials are
  // point-symmetric.
  const StandardDeviations sigma{1, 1};
  for (const auto& [order, general, symmetric] :
       {std::tuple{2, 5, 3}, {4, 14, 8}, {6, 27, 15}, {8, 44, 24}}) {
    EXPECT_EQ(GaussianWeightedBasis(order, MonomialSet::general, sigma).size(), general);
    EXPECT_EQ(GaussianWeightedBasis(order, MonomialSet::point_symmetric, sigma).size(), symmetric);
  }
}

TEST(Basis, DerivativesAgreeWithDifferencesOfTheValues) {
  const GaussianWeightedBasis basis(6, MonomialSet::general, {0.7, 1.6});
  const double x1 = 0.8, x2 = -1.1, h = 2e-2;
  const BasisFunctionDerivatives table =
      basis.basis_derivatives(Eigen::VectorXd::Constant(1, x1), Eigen::VectorXd::Constant(1, x2));
  for (Eigen::Index s = 0; s < basis.size(); ++s) {
    const auto at = [&](double i, double j) {
      return basis_values_at_point(basis, x1 + i * h, x2 + j * h)[s];
    };
    EXPECT_NEAR(table.value(0, s), at(0, 0), 1e-14);
    const auto lower = [&](double i, double j) {
      // Fourth-order difference of the first derivative in the direction (i, j).
      return (8 * (at(i, j) - at(-i, -j)) - (at(2 * i, 2 * j) - at(-2 * i, -2 * j))) / (12 * h);
    };
    EXPECT_NEAR(table.d1(0, s), lower(1, 0), 1e-5);
    EXPECT_NEAR(table.d2(0, s), lower(0, 1), 1e-5);
    EXPECT_NEAR(table.d22(0, s), (at(0, 1) - 2 * at(0, 0) + at(0, -1)) / (h * h), 1e-3);
    EXPECT_NEAR(table.d222(0, s),
                (at(0, 2) - 2 * at(0, 1) + 2 * at(0, -1) - at(0, -2)) / (2 * h * h * h), 2e-3);
    EXPECT_NEAR(
        table.d2222(0, s),
        (at(0, 2) - 4 * at(0, 1) + 6 * at(0, 0) - 4 * at(0, -1) + at(0, -2)) / std::pow(h, 4),
        4e-3);
  }
}

TEST(Basis, HasTheMeansAndTheGramMatrixOfTheWeights) {
  const StandardDeviations sigma{0.5, 2};
  const GaussianWeightedBasis basis(4, MonomialSet::general, sigma);
  const auto rule = numerics::gauss_hermite_rule(8);
  Eigen::VectorXd means = Eigen::VectorXd::Zero(basis.size());
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(basis.size(), basis.size());
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    for (std::size_t j = 0; j < rule.points.size(); ++j) {
      const Eigen::RowVectorXd values =
          basis_values_at_point(basis, sigma.x1 * rule.points[i], sigma.x2 * rule.points[j]);
      const double weight = rule.weights[i] * rule.weights[j];
      means += weight * values.transpose();
      gram += weight * values.transpose() * values;
    }
  }
  EXPECT_LT((basis.basis_function_weighted_means() - means).lpNorm<Eigen::Infinity>(), 1e-13);
  EXPECT_LT((basis.weighted_gram_matrix() - gram).lpNorm<Eigen::Infinity>(), 1e-12);
}

TEST(Basis, MonomialsHaveUnitNormUnderTheWeights) {
  const GaussianWeightedBasis basis(4, MonomialSet::point_symmetric, {0.5, 2});
  // The norm of x1^2 is sqrt(E[x1^4]) = sqrt(3) sigma_1^2, and the norm of x1 x2 is sigma_1
  // sigma_2.
  const Eigen::RowVectorXd values = basis_values_at_point(basis, 1, 1);
  EXPECT_NEAR(values[0], 1 / (0.25 * std::sqrt(3)), 1e-14);
  EXPECT_NEAR(values[1], 1.0, 1e-14);
}

TEST(Basis, ScaledCoefficientsAndPolynomialsAreInverse) {
  const GaussianWeightedBasis basis(4, MonomialSet::point_symmetric, {0.5, 2});
  const Eigen::VectorXd a = Eigen::VectorXd::LinSpaced(basis.size(), -1, 1);
  EXPECT_LT((basis.scaled_coefficients(basis.exponent_polynomial(a).terms()) - a).norm(), 1e-14);
}

}  // namespace
}  // namespace fpkcheck::epc::gaussian
