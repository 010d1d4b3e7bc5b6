#pragma once

#include <Eigen/Core>
#include <vector>

#include "epc/form/exponent_polynomial.hpp"
#include "epc/gaussian/residual.hpp"
#include "epc/options.hpp"

namespace fpkcheck::epc::gaussian {

/// Values and derivatives of the basis functions at points: row i belongs to point i, column s to
/// basis function s. The matrix d1 has the first derivatives of the basis functions in x1, the
/// matrix d22 the second derivatives in x2.
struct BasisFunctionDerivatives {
  Eigen::MatrixXd value, d1, d2, d22, d222, d2222;
};

/// Basis of the polynomial Q_n: monomials x1^p x2^q / N_pq with unit norm under the Gaussian
/// weights, N_pq^2 = E[x1^2p x2^2q] = sigma_1^2p (2p-1)!! sigma_2^2q (2q-1)!!.
class GaussianWeightedBasis {
 public:
  /// Basis function x1^p x2^q / norm.
  struct BasisFunction {
    int p, q;
    double norm;
  };

  GaussianWeightedBasis(int order, MonomialSet set, const StandardDeviations& sigma);

  int order() const { return order_; }
  MonomialSet monomial_set() const { return set_; }
  const StandardDeviations& weight_standard_deviations() const { return sigma_; }
  Eigen::Index size() const { return static_cast<Eigen::Index>(members_.size()); }
  const std::vector<BasisFunction>& basis_functions() const { return members_; }

  Eigen::MatrixXd basis_values(const Eigen::VectorXd& x1, const Eigen::VectorXd& x2) const;
  BasisFunctionDerivatives basis_derivatives(const Eigen::VectorXd& x1,
                                             const Eigen::VectorXd& x2) const;

  /// Returns the means <phi_s> of the basis functions phi_s under the Gaussian weights.
  Eigen::VectorXd basis_function_weighted_means() const;
  /// Returns the matrix of the means <phi_s phi_k> of products of basis functions under the
  /// Gaussian weights; the diagonal elements are 1.
  Eigen::MatrixXd weighted_gram_matrix() const;

  /// Returns the exponent Q_n as a sum of monomials x1^p x2^q, from the coefficients of Q_n in the
  /// scaled basis functions.
  ExponentPolynomial exponent_polynomial(const Eigen::VectorXd& scaled_coefficients) const;
  /// Returns the coefficients of a polynomial in the scaled basis functions. Terms of a polynomial
  /// whose monomials are not in the basis of the closure are ignored.
  Eigen::VectorXd scaled_coefficients(const std::vector<ExponentMonomial>& terms) const;

 private:
  /// Returns the products of column p of `of_x1` and column q of `of_x2`, divided by the norm, for
  /// every basis function x1^p x2^q / norm.
  Eigen::MatrixXd products_of_factor_columns(const Eigen::MatrixXd& of_x1,
                                             const Eigen::MatrixXd& of_x2) const;

  int order_;
  MonomialSet set_;
  StandardDeviations sigma_;
  std::vector<BasisFunction> members_;
};

/// Points and weights of a quadrature rule in the plane of the coordinates x1 and x2.
struct PlaneQuadratureRule {
  std::vector<double> x1, x2, weights;

  void add_quadrature_point(double at_x1, double at_x2, double weight);
};

/// Returns a quadrature rule for functions that are even under (x1, x2) -> (-x1, -x2), with half of
/// the points of the given rule. Of each pair of opposite points, the quadrature rule for even
/// functions has one point with the sum of both weights.
/// @pre up to rounding, the given rule is symmetric under (x1, x2) -> (-x1, -x2)
PlaneQuadratureRule fold_point_symmetric_rule(const PlaneQuadratureRule& rule);

/// Quadrature rule in the (x1, x2) plane, with values of the basis functions at its points.
class GaussianProjectionNodes {
 public:
  GaussianProjectionNodes(const PlaneQuadratureRule& rule, const GaussianWeightedBasis& basis);

  Eigen::Index size() const { return x1_.size(); }
  double x1(Eigen::Index i) const { return x1_[i]; }
  double x2(Eigen::Index i) const { return x2_[i]; }
  const BasisFunctionDerivatives& basis() const { return basis_; }

  /// Returns the derivatives of the exponent Q_n at each quadrature point.
  std::vector<ExponentPartialDerivatives> exponent_derivatives(
      const Eigen::VectorXd& scaled_coefficients) const;

  /// Projects a function on the basis functions phi_s, by the values of the function at the
  /// quadrature points. Row s of the projection of a function is sum_i w_i values_i phi_s(x_i),
  /// over the quadrature points x_i with weights w_i.
  Eigen::VectorXd project_on_basis_functions(const Eigen::VectorXd& values) const;
  Eigen::MatrixXd project_on_basis_functions(const Eigen::MatrixXd& values) const;
  /// Returns the Jacobian of a projection: column k has the derivatives in coefficient k of Q_n.
  /// @param gradients gradients of the projected function with respect to the derivatives of the
  ///   exponent Q_n, at each point
  Eigen::MatrixXd project_gradients_on_basis(
      const std::vector<ExponentPartialDerivatives>& gradients) const;

 private:
  Eigen::VectorXd x1_, x2_;
  BasisFunctionDerivatives basis_;
  // Quadrature weights times values of the basis functions, of shape (points, basis functions)
  Eigen::MatrixXd weighted_tests_;
};

}  // namespace fpkcheck::epc::gaussian
