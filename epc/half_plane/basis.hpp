#pragma once

#include <Eigen/Core>
#include <vector>

#include "epc/form/polynomial.hpp"
#include "epc/half_plane/orthonormal_polynomials.hpp"
#include "epc/half_plane/points.hpp"

namespace fpkcheck::epc::half_plane {

/// The functions h_p(s) g_q(t), 1 <= p + q <= n, of the coordinates of Points, with polynomials
/// that are orthonormal under the marginals of a density near the one sought. They span the
/// monomials s^p t^q of degree 1 .. n, but for a constant.
class Basis {
 public:
  struct Member {
    int p, q;
  };

  /// @param points quadrature points of the domain
  /// @param mass of the near density at each point, summing to 1
  Basis(int order, const Points& points, const Eigen::VectorXd& mass);

  int order() const { return order_; }
  Eigen::Index size() const { return static_cast<Eigen::Index>(members_.size()); }
  const std::vector<Member>& members() const { return members_; }
  const OrthonormalPolynomials& of_s() const { return of_s_; }
  const OrthonormalPolynomials& of_t() const { return of_t_; }

  /// Values at points: shape (points, size()).
  Eigen::MatrixXd values(const Eigen::VectorXd& s, const Eigen::VectorXd& t) const;

  /// Q_n of the coefficients a, in monomials of s and t without the constant.
  Polynomial polynomial(const Eigen::VectorXd& a) const;

 private:
  int order_;
  std::vector<Member> members_;
  OrthonormalPolynomials of_s_, of_t_;
};

/// The member-by-member products of two tables: column k is s_table.col(p_k) * t_table.col(q_k).
Eigen::MatrixXd products(const std::vector<Basis::Member>& members, const Eigen::MatrixXd& s_table,
                         const Eigen::MatrixXd& t_table);

}  // namespace fpkcheck::epc::half_plane
