#pragma once

#include <vector>

#include <Eigen/Core>

#include "epc/gaussian/basis.hpp"
#include "epc/gaussian/residual.hpp"

namespace fpkcheck::epc::gaussian {

/// Quadrature rule in the plane: points and weights.
struct PlaneRule {
  std::vector<double> x1, x2, weights;

  void add(double at_x1, double at_x2, double weight);
};

/// Quadrature rule for integrands even under (x1, x2) -> (-x1, -x2): one point of each pair, with the
/// sum of both weights.
/// @pre the rule has this symmetry up to rounding
PlaneRule folded(const PlaneRule& rule);

/// Quadrature rule in the plane with a table of the basis at its points, common to all iterates.
class ProjectionNodes {
 public:
  ProjectionNodes(const PlaneRule& rule, const Basis& basis);

  Eigen::Index size() const { return x1_.size(); }
  double x1(Eigen::Index i) const { return x1_[i]; }
  double x2(Eigen::Index i) const { return x2_[i]; }
  const BasisTable& basis() const { return basis_; }

  /// Derivatives of Q_n at each point, for scaled coefficients a.
  std::vector<Derivatives> exponent_derivatives(const Eigen::VectorXd& a) const;

  /// Projection: sum_i w_i values_i phi_s(x_i) in row s.
  Eigen::VectorXd project(const Eigen::VectorXd& values) const;
  /// Projection of a matrix of values with a column for each unknown.
  Eigen::MatrixXd project(const Eigen::MatrixXd& values) const;
  /// Derivative of a projection by unknown k in column k.
  /// @param gradients of the values with respect to the derivatives of Q_n, at each point
  Eigen::MatrixXd project_gradients(const std::vector<Derivatives>& gradients) const;

 private:
  Eigen::VectorXd x1_, x2_;
  BasisTable basis_;
  Eigen::MatrixXd weighted_tests_;  // shape (points, basis functions)
};

}  // namespace fpkcheck::epc::gaussian
