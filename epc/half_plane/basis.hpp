#pragma once

#include <Eigen/Core>
#include <vector>

#include "epc/form/polynomial.hpp"
#include "epc/half_plane/orthonormal_polynomials.hpp"
#include "epc/half_plane/quadrature_points.hpp"

namespace fpkcheck::epc::half_plane {

/// Basis of products h_p(s) g_q(t), 1 <= p + q <= n, in the coordinates s and t of
/// QuadraturePoints. The polynomials h and g are orthonormal under the marginal densities of an
/// approximation of the density. Up to constants, the basis spans the monomials s^p t^q of degree 1
/// .. n.
class Basis {
 public:
  /// Degrees p and q of a basis function h_p(s) g_q(t).
  struct BasisFunction {
    int p, q;
  };

  /// @param points quadrature points of the domain
  /// @param mass probability of the approximate density at each point; the sum is 1
  Basis(int order, const QuadraturePoints& points, const Eigen::VectorXd& mass);

  int order() const { return order_; }
  Eigen::Index size() const { return static_cast<Eigen::Index>(members_.size()); }
  const std::vector<BasisFunction>& members() const { return members_; }
  const OrthonormalPolynomials& polynomials_in_s() const { return of_s_; }
  const OrthonormalPolynomials& polynomials_in_t() const { return of_t_; }

  /// Values of the basis functions at points, shape (number of points, size()).
  Eigen::MatrixXd basis_values(const Eigen::VectorXd& s, const Eigen::VectorXd& t) const;

  /// Q_n in monomials of s and t, from the coefficients a in the basis, without the constant term.
  Polynomial exponent_polynomial(const Eigen::VectorXd& a) const;

 private:
  int order_;
  std::vector<BasisFunction> members_;
  OrthonormalPolynomials of_s_, of_t_;
};

/// Table of products for all basis functions, from two tables of polynomials: column k is
/// s_table.col(p_k) * t_table.col(q_k).
Eigen::MatrixXd products_of_tables(const std::vector<Basis::BasisFunction>& members,
                                   const Eigen::MatrixXd& s_table, const Eigen::MatrixXd& t_table);

}  // namespace fpkcheck::epc::half_plane
