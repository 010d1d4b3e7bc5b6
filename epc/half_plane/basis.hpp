#pragma once

#include <Eigen/Core>
#include <vector>

#include "epc/form/polynomial.hpp"
#include "epc/half_plane/orthonormal_polynomials.hpp"
#include "epc/half_plane/quadrature_points.hpp"

namespace fpkcheck::epc::half_plane {

/// Basis functions h_p(s) g_q(t), 1 <= p + q <= n, in the coordinates of QuadraturePoints. The
/// polynomials h and g are orthonormal under the marginals of an approximation of the density. Up
/// to constants the basis spans the monomials s^p t^q of degree 1 .. n.
class Basis {
 public:
  struct Member {
    int p, q;
  };

  /// @param points quadrature points of the domain
  /// @param mass of the approximate density at each point, with sum 1
  Basis(int order, const QuadraturePoints& points, const Eigen::VectorXd& mass);

  int order() const { return order_; }
  Eigen::Index size() const { return static_cast<Eigen::Index>(members_.size()); }
  const std::vector<Member>& members() const { return members_; }
  const OrthonormalPolynomials& polynomials_in_s() const { return of_s_; }
  const OrthonormalPolynomials& polynomials_in_t() const { return of_t_; }

  /// Values at points: shape (points, size()).
  Eigen::MatrixXd values(const Eigen::VectorXd& s, const Eigen::VectorXd& t) const;

  /// Q_n with the coefficients a, in monomials of s and t, without its constant.
  Polynomial polynomial(const Eigen::VectorXd& a) const;

 private:
  int order_;
  std::vector<Member> members_;
  OrthonormalPolynomials of_s_, of_t_;
};

/// Products of two tables for each member: column k is s_table.col(p_k) * t_table.col(q_k).
Eigen::MatrixXd products(const std::vector<Basis::Member>& members, const Eigen::MatrixXd& s_table,
                         const Eigen::MatrixXd& t_table);

}  // namespace fpkcheck::epc::half_plane
