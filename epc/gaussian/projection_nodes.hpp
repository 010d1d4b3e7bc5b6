#pragma once

#include <vector>

#include <Eigen/Core>

#include "epc/gaussian/basis.hpp"
#include "epc/gaussian/residual.hpp"

namespace fpkcheck::epc::gaussian {

/// Quadrature rule in the plane: points and weights.
struct PlaneQuadratureRule {
  std::vector<double> x1, x2, weights;

  void add_point(double at_x1, double at_x2, double weight);
};

/// Quadrature rule for integrands that are even under (x1, x2) -> (-x1, -x2). The rule has one
/// point of each pair of opposite points, with the sum of both weights.
/// @pre up to rounding, the given rule has this symmetry
PlaneQuadratureRule fold_symmetric_rule(const PlaneQuadratureRule& rule);

/// Quadrature rule in the plane, with a table of the basis functions at the quadrature points. All
/// Newton iterates use the same table.
class ProjectionNodes {
 public:
  ProjectionNodes(const PlaneQuadratureRule& rule, const Basis& basis);

  Eigen::Index size() const { return x1_.size(); }
  double x1(Eigen::Index i) const { return x1_[i]; }
  double x2(Eigen::Index i) const { return x2_[i]; }
  const BasisDerivatives& basis() const { return basis_; }

  /// The derivatives of Q_n at each point, for scaled coefficients a.
  std::vector<ExponentDerivatives> exponent_derivatives(const Eigen::VectorXd& a) const;

  /// Projects a function, given by its values at the points, on the basis functions phi_s. Row s of
  /// the result is sum_i w_i values_i phi_s(x_i).
  Eigen::VectorXd project_on_basis(const Eigen::VectorXd& values) const;
  /// Projects several functions on the basis functions: column k of `values` has the values of
  /// function k at the points.
  Eigen::MatrixXd project_on_basis(const Eigen::MatrixXd& values) const;
  /// Jacobian of a projection: column k is the derivative with respect to unknown k.
  /// @param gradients gradients of the projected function with respect to the derivatives of Q_n,
  ///        at each point
  Eigen::MatrixXd project_gradients_on_basis(
      const std::vector<ExponentDerivatives>& gradients) const;

 private:
  Eigen::VectorXd x1_, x2_;
  BasisDerivatives basis_;
  Eigen::MatrixXd weighted_tests_;  // shape (points, basis functions)
};

}  // namespace fpkcheck::epc::gaussian
