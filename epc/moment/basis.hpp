#pragma once

#include <vector>

#include <Eigen/Dense>

#include "epc/moment/energy_domain.hpp"
#include "epc/moment/orthonormal_polynomials.hpp"
#include "epc/polynomial.hpp"

namespace fpkcheck::epc::moment {

/// The functions h_p(y) g_q(v), 1 <= p + q <= n, with polynomials that are orthonormal under the
/// marginals of a density near the one sought. They span the monomials y^p v^q of degree 1 .. n,
/// but for a constant.
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
  const OrthonormalPolynomials& of_y() const { return of_y_; }
  const OrthonormalPolynomials& of_v() const { return of_v_; }

  /// Values at points: shape (points, size()).
  Eigen::MatrixXd values(const Eigen::VectorXd& y, const Eigen::VectorXd& v) const;

  /// Q_n of the coefficients a, in physical monomials without the constant.
  Polynomial polynomial(const Eigen::VectorXd& a) const;

 private:
  int order_;
  std::vector<Member> members_;
  OrthonormalPolynomials of_y_, of_v_;
};

/// The member-by-member products of two tables: column s is y_table.col(p_s) * v_table.col(q_s).
Eigen::MatrixXd products(const std::vector<Basis::Member>& members, const Eigen::MatrixXd& y_table,
                         const Eigen::MatrixXd& v_table);

}  // namespace fpkcheck::epc::moment
