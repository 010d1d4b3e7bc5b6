#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "epc/half_plane/half_plane_basis.hpp"

namespace fpkcheck::epc::half_plane {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// A half-Gaussian on [0, 7], under which Hermite polynomials are not orthogonal.
struct HalfGaussian {
  VectorXd x = VectorXd::LinSpaced(400, 0, 7);
  VectorXd weight = (-x.array().square() / 2).exp();
  HalfGaussian() { weight /= weight.sum(); }
};

TEST(OrthonormalPolynomials, AreOrthonormalUnderTheirMeasure) {
  const HalfGaussian m;
  const OrthonormalPolynomials h(m.x, m.weight, 12);
  const MatrixXd values = h.polynomial_values(m.x);
  const MatrixXd gram = values.transpose() * m.weight.asDiagonal() * values;
  // Stieltjes' procedure loses some digits with the degree.
  EXPECT_LT((gram - MatrixXd::Identity(13, 13)).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(OrthonormalPolynomials, DerivativesAreThoseOfTheMonomials) {
  const HalfGaussian m;
  const OrthonormalPolynomials h(m.x, m.weight, 6);
  const MatrixXd c = h.monomial_coefficients();
  const VectorXd at = VectorXd::LinSpaced(5, -1, 3);
  const auto tables = h.polynomial_derivative_tables(at, 6);
  for (int j = 0; j <= 6; ++j) {
    for (int k = 0; k <= 6; ++k) {
      for (int i = 0; i < at.size(); ++i) {
        double exact = 0;
        for (int p = j; p <= k; ++p) {
          exact += c(k, p) * std::tgamma(p + 1) / std::tgamma(p - j + 1) * std::pow(at[i], p - j);
        }
        EXPECT_NEAR(tables[j](i, k), exact, 1e-10 * (1 + std::abs(exact)))
            << "derivative " << j << " of h_" << k << " at " << at[i];
      }
    }
  }
}

// Points on lines of constant s, with different numbers of points; two lines have one point each.
QuadraturePoints points_on_lines() {
  const std::vector<std::pair<double, int>> lines{
      {0.1, 9}, {0.7, 14}, {1.2, 1}, {1.9, 11}, {2.3, 1}};
  std::vector<double> s, t;
  for (const auto& [at, count] : lines) {
    for (int j = 0; j < count; ++j) {
      s.push_back(at);
      t.push_back(std::sin(1.3 * j + at));
    }
  }
  QuadraturePoints points = QuadraturePoints::zero_initialised(std::ssize(s));
  points.s = VectorXd::Map(s.data(), std::ssize(s));
  points.t = VectorXd::Map(t.data(), std::ssize(t));
  return points;
}

TEST(BasisAtPoints, SumsAreThoseOfTheTableOfBasisFunctions) {
  const QuadraturePoints points = points_on_lines();
  VectorXd mass = (VectorXd::LinSpaced(points.size(), 0, 3).array().cos() + 1.5).matrix();
  mass /= mass.sum();
  const OrthonormalBasis basis(4, points, mass);
  const BasisValuesAtPoints at_points(basis, points.s, points.t);
  const MatrixXd table = basis.basis_values(points.s, points.t);
  ASSERT_EQ(at_points.size(), table.cols());

  const VectorXd a = VectorXd::LinSpaced(basis.size(), -1, 2);
  EXPECT_LT((at_points.basis_function_combination(a) - table * a).norm(),
            1e-12 * (table * a).norm());

  const VectorXd means = table.transpose() * mass;
  EXPECT_LT((at_points.basis_means_under_mass(mass) - means).norm(), 1e-12 * (1 + means.norm()));

  MatrixXd with_one(points.size(), basis.size() + 1);
  with_one << VectorXd::Ones(points.size()), table;
  const MatrixXd moments = with_one.transpose() * mass.asDiagonal() * with_one;
  EXPECT_LT((at_points.basis_second_moments(mass) - moments).norm(), 1e-12 * moments.norm());

  MatrixXd values(points.size(), 3);
  values << points.t, points.s.cwiseProduct(points.t), points.t.array().exp().matrix();
  const MatrixXd products = values.transpose() * mass.asDiagonal() * table;
  EXPECT_LT((at_points.basis_mean_products(values, mass) - products).norm(),
            1e-12 * products.norm());
}

}  // namespace
}  // namespace fpkcheck::epc::half_plane
