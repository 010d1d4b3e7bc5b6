#pragma once

#include <vector>

#include <Eigen/Core>

#include "epc/gaussian/basis.hpp"
#include "epc/gaussian/residual.hpp"

namespace fpkcheck::epc::gaussian {

/// A quadrature rule in the plane, as points and weights.
struct PlaneRule {
  std::vector<double> x1, x2, weights;

  void add(double at_x1, double at_x2, double weight);
};

/// The rule for integrands that are even under (x1, x2) -> (-x1, -x2): of each pair of points one
/// is kept, with the weights of both. The rule itself must be so symmetric, up to rounding.
PlaneRule folded(const PlaneRule& rule);

/// A quadrature rule in the plane with a basis at its points. One table serves every iterate.
class ProjectionNodes {
 public:
  ProjectionNodes(const PlaneRule& rule, const Basis& basis);

  Eigen::Index size() const { return x1_.size(); }
  double x1(Eigen::Index i) const { return x1_[i]; }
  double x2(Eigen::Index i) const { return x2_[i]; }
  const BasisTable& basis() const { return basis_; }

  /// The derivatives of Q_n at each point, for scaled coefficients a.
  std::vector<Derivatives> of_q(const Eigen::VectorXd& a) const;

  /// sum_i w_i values_i phi_s(x_i) in row s.
  Eigen::VectorXd project(const Eigen::VectorXd& values) const;
  /// The same for a matrix of values with a column for each unknown.
  Eigen::MatrixXd project(const Eigen::MatrixXd& values) const;
  /// The same for values whose dependence on the derivatives of Q_n at each point is given by
  /// gradients: the derivative by unknown k in column k.
  Eigen::MatrixXd project_gradients(const std::vector<Derivatives>& gradients) const;

 private:
  Eigen::VectorXd x1_, x2_;
  BasisTable basis_;
  Eigen::MatrixXd weighted_tests_;  // shape (points, basis functions)
};

}  // namespace fpkcheck::epc::gaussian
