#include "epc/gaussian/projection_nodes.hpp"

#include <cmath>

namespace fpkcheck::epc::gaussian {
namespace {

Eigen::VectorXd as_vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

void PlaneQuadratureRule::add_point(double at_x1, double at_x2, double weight) {
  x1.push_back(at_x1);
  x2.push_back(at_x2);
  weights.push_back(weight);
}

PlaneQuadratureRule fold_symmetric_rule(const PlaneQuadratureRule& rule) {
  const double rounding = 1e-9 * (std::abs(rule.x1.front()) + std::abs(rule.x2.front()));
  const auto sign = [&](double x) { return x > rounding ? 1 : x < -rounding ? -1 : 0; };
  PlaneQuadratureRule half;
  for (std::size_t i = 0; i < rule.weights.size(); ++i) {
    const int s1 = sign(rule.x1[i]), s2 = sign(rule.x2[i]);
    const int side = s1 != 0 ? s1 : s2;
    if (side >= 0) half.add_point(rule.x1[i], rule.x2[i], (side > 0 ? 2 : 1) * rule.weights[i]);
  }
  return half;
}

ProjectionNodes::ProjectionNodes(const PlaneQuadratureRule& rule, const Basis& basis)
    : x1_(as_vector(rule.x1)),
      x2_(as_vector(rule.x2)),
      basis_(basis.basis_derivatives(x1_, x2_)),
      weighted_tests_(as_vector(rule.weights).asDiagonal() * basis_.value) {}

std::vector<ExponentDerivatives> ProjectionNodes::exponent_derivatives(
    const Eigen::VectorXd& a) const {
  const Eigen::VectorXd q1 = basis_.d1 * a, q2 = basis_.d2 * a, q22 = basis_.d22 * a,
                        q222 = basis_.d222 * a, q2222 = basis_.d2222 * a;
  std::vector<ExponentDerivatives> result;
  result.reserve(static_cast<std::size_t>(size()));
  for (Eigen::Index i = 0; i < size(); ++i) {
    result.push_back({q1[i], q2[i], q22[i], q222[i], q2222[i]});
  }
  return result;
}

Eigen::VectorXd ProjectionNodes::project_on_basis(const Eigen::VectorXd& values) const {
  return weighted_tests_.transpose() * values;
}

Eigen::MatrixXd ProjectionNodes::project_on_basis(const Eigen::MatrixXd& values) const {
  return weighted_tests_.transpose() * values;
}

Eigen::MatrixXd ProjectionNodes::project_gradients_on_basis(
    const std::vector<ExponentDerivatives>& gradients) const {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(size(), basis_.value.cols());
  const auto add = [&](double ExponentDerivatives::*part, const Eigen::MatrixXd& members) {
    Eigen::VectorXd factor(size());
    for (Eigen::Index i = 0; i < size(); ++i) factor[i] = gradients[i].*part;
    if (!factor.isZero(0)) rows += factor.asDiagonal() * members;
  };
  add(&ExponentDerivatives::q1, basis_.d1);
  add(&ExponentDerivatives::q2, basis_.d2);
  add(&ExponentDerivatives::q22, basis_.d22);
  add(&ExponentDerivatives::q222, basis_.d222);
  add(&ExponentDerivatives::q2222, basis_.d2222);
  return project_on_basis(rows);
}

}  // namespace fpkcheck::epc::gaussian
