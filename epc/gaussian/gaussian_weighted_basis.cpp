#include "epc/gaussian/gaussian_weighted_basis.hpp"

#include <boost/math/special_functions/factorials.hpp>
#include <cmath>

namespace fpkcheck::epc::gaussian {
namespace {

// Returns the moment E[x^p] of a Gaussian variable x ~ N(0, sigma^2).
double gaussian_moment(int p, double sigma) {
  if (p % 2 != 0) return 0;
  const double factor =
      p == 0 ? 1 : boost::math::double_factorial<double>(static_cast<unsigned>(p - 1));
  return std::pow(sigma, p) * factor;
}

// Returns the norm sqrt(E[x^2p]) of the power x^p for a Gaussian variable x ~ N(0, sigma^2).
double norm_of_power(int p, double sigma) { return std::sqrt(gaussian_moment(2 * p, sigma)); }

// Returns the j-th derivatives of the powers of x at points: column p belongs to x^p.
Eigen::MatrixXd power_derivatives(const Eigen::VectorXd& x, int degree, int j) {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(x.size(), degree + 1);
  Eigen::VectorXd power = Eigen::VectorXd::Ones(x.size());
  for (int p = j; p <= degree; ++p) {
    double factor = 1;
    for (int i = 0; i < j; ++i) factor *= p - i;
    columns.col(p) = factor * power;
    power.array() *= x.array();
  }
  return columns;
}

}  // namespace

GaussianWeightedBasis::GaussianWeightedBasis(int order, MonomialSet set,
                                             const StandardDeviations& sigma)
    : order_(order), set_(set), sigma_(sigma) {
  const int step = set == MonomialSet::point_symmetric ? 2 : 1;
  for (int m = step; m <= order; m += step) {
    for (int l = 0; l <= m; ++l) {
      members_.push_back({m - l, l, norm_of_power(m - l, sigma.x1) * norm_of_power(l, sigma.x2)});
    }
  }
}

Eigen::MatrixXd GaussianWeightedBasis::products_of_factor_columns(
    const Eigen::MatrixXd& of_x1, const Eigen::MatrixXd& of_x2) const {
  Eigen::MatrixXd result(of_x1.rows(), size());
  for (Eigen::Index s = 0; s < size(); ++s) {
    const auto& [p, q, norm] = members_[s];
    result.col(s) = of_x1.col(p).cwiseProduct(of_x2.col(q)) / norm;
  }
  return result;
}

Eigen::MatrixXd GaussianWeightedBasis::basis_values(const Eigen::VectorXd& x1,
                                                    const Eigen::VectorXd& x2) const {
  return products_of_factor_columns(power_derivatives(x1, order_, 0),
                                    power_derivatives(x2, order_, 0));
}

BasisFunctionDerivatives GaussianWeightedBasis::basis_derivatives(const Eigen::VectorXd& x1,
                                                                  const Eigen::VectorXd& x2) const {
  const Eigen::MatrixXd of_x1 = power_derivatives(x1, order_, 0);
  const auto in_x2 = [&](int j) {
    return products_of_factor_columns(of_x1, power_derivatives(x2, order_, j));
  };
  return {.value = in_x2(0),
          .d1 = products_of_factor_columns(power_derivatives(x1, order_, 1),
                                           power_derivatives(x2, order_, 0)),
          .d2 = in_x2(1),
          .d22 = in_x2(2),
          .d222 = in_x2(3),
          .d2222 = in_x2(4)};
}

Eigen::VectorXd GaussianWeightedBasis::basis_function_weighted_means() const {
  return Eigen::VectorXd::NullaryExpr(size(), [&](Eigen::Index s) {
    const auto& [p, q, norm] = members_[static_cast<std::size_t>(s)];
    return gaussian_moment(p, sigma_.x1) * gaussian_moment(q, sigma_.x2) / norm;
  });
}

Eigen::MatrixXd GaussianWeightedBasis::weighted_gram_matrix() const {
  return Eigen::MatrixXd::NullaryExpr(size(), size(), [&](Eigen::Index s, Eigen::Index k) {
    const auto &a = members_[static_cast<std::size_t>(s)],
               &b = members_[static_cast<std::size_t>(k)];
    return gaussian_moment(a.p + b.p, sigma_.x1) * gaussian_moment(a.q + b.q, sigma_.x2) /
           (a.norm * b.norm);
  });
}

ExponentPolynomial GaussianWeightedBasis::exponent_polynomial(
    const Eigen::VectorXd& scaled_coefficients) const {
  std::vector<ExponentMonomial> terms;
  for (Eigen::Index s = 0; s < size(); ++s) {
    terms.push_back({members_[s].p, members_[s].q, scaled_coefficients[s] / members_[s].norm});
  }
  return ExponentPolynomial(std::move(terms));
}

Eigen::VectorXd GaussianWeightedBasis::scaled_coefficients(
    const std::vector<ExponentMonomial>& terms) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(size());
  for (Eigen::Index s = 0; s < size(); ++s) {
    for (const auto& [p, q, a] : terms) {
      if (p == members_[s].p && q == members_[s].q) result[s] += a * members_[s].norm;
    }
  }
  return result;
}

namespace {

Eigen::VectorXd to_eigen_vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

void PlaneQuadratureRule::add_quadrature_point(double at_x1, double at_x2, double weight) {
  x1.push_back(at_x1);
  x2.push_back(at_x2);
  weights.push_back(weight);
}

PlaneQuadratureRule fold_point_symmetric_rule(const PlaneQuadratureRule& rule) {
  const double rounding = 1e-9 * (std::abs(rule.x1.front()) + std::abs(rule.x2.front()));
  const auto sign = [&](double x) { return x > rounding ? 1 : x < -rounding ? -1 : 0; };
  PlaneQuadratureRule half;
  for (std::size_t i = 0; i < rule.weights.size(); ++i) {
    const int s1 = sign(rule.x1[i]), s2 = sign(rule.x2[i]);
    const int side = s1 != 0 ? s1 : s2;
    if (side >= 0)
      half.add_quadrature_point(rule.x1[i], rule.x2[i], (side > 0 ? 2 : 1) * rule.weights[i]);
  }
  return half;
}

GaussianProjectionNodes::GaussianProjectionNodes(const PlaneQuadratureRule& rule,
                                                 const GaussianWeightedBasis& basis)
    : x1_(to_eigen_vector(rule.x1)),
      x2_(to_eigen_vector(rule.x2)),
      basis_(basis.basis_derivatives(x1_, x2_)),
      weighted_tests_(to_eigen_vector(rule.weights).asDiagonal() * basis_.value) {}

std::vector<ExponentPartialDerivatives> GaussianProjectionNodes::exponent_derivatives(
    const Eigen::VectorXd& a) const {
  const Eigen::VectorXd q1 = basis_.d1 * a, q2 = basis_.d2 * a, q22 = basis_.d22 * a,
                        q222 = basis_.d222 * a, q2222 = basis_.d2222 * a;
  std::vector<ExponentPartialDerivatives> result;
  result.reserve(static_cast<std::size_t>(size()));
  for (Eigen::Index i = 0; i < size(); ++i) {
    result.push_back({q1[i], q2[i], q22[i], q222[i], q2222[i]});
  }
  return result;
}

Eigen::VectorXd GaussianProjectionNodes::project_on_basis_functions(
    const Eigen::VectorXd& values) const {
  return weighted_tests_.transpose() * values;
}

Eigen::MatrixXd GaussianProjectionNodes::project_on_basis_functions(
    const Eigen::MatrixXd& values) const {
  return weighted_tests_.transpose() * values;
}

Eigen::MatrixXd GaussianProjectionNodes::project_gradients_on_basis(
    const std::vector<ExponentPartialDerivatives>& gradients) const {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(size(), basis_.value.cols());
  const auto add = [&](double ExponentPartialDerivatives::*part, const Eigen::MatrixXd& members) {
    Eigen::VectorXd factor(size());
    for (Eigen::Index i = 0; i < size(); ++i) factor[i] = gradients[i].*part;
    if (!factor.isZero(0)) rows += factor.asDiagonal() * members;
  };
  add(&ExponentPartialDerivatives::q1, basis_.d1);
  add(&ExponentPartialDerivatives::q2, basis_.d2);
  add(&ExponentPartialDerivatives::q22, basis_.d22);
  add(&ExponentPartialDerivatives::q222, basis_.d222);
  add(&ExponentPartialDerivatives::q2222, basis_.d2222);
  return project_on_basis_functions(rows);
}

}  // namespace fpkcheck::epc::gaussian
