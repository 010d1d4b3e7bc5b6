#include <gtest/gtest.h>

#include <cmath>

#include "epc/half_plane/basis.hpp"

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
  const auto tables = h.derivative_tables(at, 6);
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

}  // namespace
}  // namespace fpkcheck::epc::half_plane
