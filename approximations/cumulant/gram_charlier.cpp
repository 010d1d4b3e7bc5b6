#include "approximations/cumulant/gram_charlier.hpp"

#include <algorithm>
#include <boost/math/special_functions/factorials.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cassert>
#include <cmath>
#include <numbers>

namespace fpkcheck::cumulant {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Returns the binomial coefficients C(n, k) as entries (n, k) of a matrix, by Pascal's rule.
MatrixXd binomial_coefficients(Index max_n) {
  MatrixXd binomial = MatrixXd::Zero(max_n + 1, max_n + 1);
  for (Index n = 0; n <= max_n; ++n) {
    binomial(n, 0) = 1;
    for (Index k = 1; k <= n; ++k) binomial(n, k) = binomial(n - 1, k - 1) + binomial(n - 1, k);
  }
  return binomial;
}

double factorial(int n) { return boost::math::factorial<double>(static_cast<unsigned>(n)); }

// Returns the coefficients of the Hermite polynomials He_0, .. He_n in the rows of a matrix, by
// He_{k+1}(x) = x He_k(x) - k He_{k-1}(x).
MatrixXd hermite_coefficients(int n) {
  MatrixXd he = MatrixXd::Zero(n + 1, n + 1);
  he(0, 0) = 1;
  for (int k = 0; k < n; ++k) {
    he.row(k + 1).tail(n) = he.row(k).head(n);
    if (k > 0) he.row(k + 1) -= k * he.row(k - 1);
  }
  return he;
}

}  // namespace

MatrixXd moments_from_cumulants(const MatrixXd& cumulants, int max_order) {
  const Index limit = cumulants.rows() - 1;  // largest exponent of a cumulant
  const MatrixXd binomial = binomial_coefficients(max_order);
  MatrixXd moments = MatrixXd::Zero(max_order + 1, max_order + 1);
  moments(0, 0) = 1;
  for (Index b = 1; b <= max_order; ++b) {
    for (Index j = 0; j <= std::min(b - 1, limit - 1); ++j) {
      moments(0, b) += binomial(b - 1, j) * cumulants(0, j + 1) * moments(0, b - 1 - j);
    }
  }
  for (Index a = 0; a < max_order; ++a) {
    for (Index b = 0; a + 1 + b <= max_order; ++b) {
      for (Index i = 0; i <= std::min(a, limit - 1); ++i) {
        for (Index j = 0; j <= std::min(b, limit); ++j) {
          moments(a + 1, b) +=
              binomial(a, i) * binomial(b, j) * cumulants(i + 1, j) * moments(a - i, b - j);
        }
      }
    }
  }
  return moments;
}

MatrixXd gram_charlier_polynomial(const MatrixXd& moments, int order) {
  assert(moments.rows() > order);
  const MatrixXd he = hermite_coefficients(order);
  const MatrixXd means = he * moments.topLeftCorner(order + 1, order + 1) * he.transpose();
  MatrixXd weights = MatrixXd::Zero(order + 1, order + 1);
  for (int i = 0; i <= order; ++i) {
    for (int j = 0; i + j <= order; ++j)
      weights(i, j) = means(i, j) / (factorial(i) * factorial(j));
  }
  return he.transpose() * weights * he;
}

double absolute_normal_moment(int k) {
  return std::pow(2, k / 2.0) * boost::math::tgamma((k + 1) / 2.0) * std::numbers::inv_sqrtpi;
}

double half_plane_moment(const MatrixXd& polynomial, int a, int b) {
  assert((a + b) % 2 == 1);
  double moment = 0;
  for (int i = 0; i < polynomial.rows(); ++i) {
    for (int j = 0; j < polynomial.cols(); ++j) {
      if ((b + j) % 2 == 1 || polynomial(i, j) == 0) continue;
      moment += polynomial(i, j) * absolute_normal_moment(a + i) * absolute_normal_moment(b + j);
    }
  }
  return moment;
}

}  // namespace fpkcheck::cumulant
