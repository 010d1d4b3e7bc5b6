#pragma once

#include <Eigen/Core>
#include <vector>

#include "epc/form/polynomial.hpp"

namespace fpkcheck::epc::half_plane {

/// Numbers of quadrature points in the coordinates s and t, and on the wall.
struct QuadratureSize {
  int s, t, wall;
};

/// Quadrature rule on the half-plane y >= 0, which approximates an integral of f by
/// sum_i weight_i f(y_i, v_i). Q_n is a polynomial of the coordinates s and t, which are (y, v) for
/// the formulation moment, (rho, theta) for polar, and (rho, v) for contact.
struct QuadraturePoints {
  Eigen::VectorXd s, t;
  Eigen::VectorXd y, v;
  Eigen::VectorXd energy;  ///< energy h, the argument of the confinement
  Eigen::VectorXd weight;  ///< quadrature weights for dy dv

  /// Quadrature rule of `count` points whose coordinates, energies and weights are all 0.
  static QuadraturePoints zeros(Eigen::Index count);
  Eigen::Index size() const { return weight.size(); }
};

/// Polynomials h_0 = 1, h_1 .. h_n of one variable that are orthonormal under a discrete measure,
///
///     b_i h_{i+1}(x) = (x - a_i) h_i(x) - b_{i-1} h_{i-1}(x),
///
/// by Stieltjes' procedure. The discrete measure approximates a marginal density. Hermite
/// polynomials, which are orthonormal on the whole line, lose accuracy on y >= 0 as the order
/// grows.
class OrthonormalPolynomials {
 public:
  /// @param points,weights points and weights of the measure, shape (number of points). The sum of
  ///   the weights is 1, and more than `degree` points are distinct
  /// @param degree largest degree n
  OrthonormalPolynomials(const Eigen::VectorXd& points, const Eigen::VectorXd& weights, int degree);

  int degree() const { return static_cast<int>(centre_.size()); }

  /// Tables of the polynomials and their derivatives: entry [j](i, k) is the j-th derivative of h_k
  /// at x_i.
  /// @param order highest derivative j
  std::vector<Eigen::MatrixXd> derivative_tables(const Eigen::VectorXd& x, int order) const;
  /// Values of the polynomials: entry (i, k) is h_k(x_i).
  Eigen::MatrixXd polynomial_values(const Eigen::VectorXd& x) const {
    return derivative_tables(x, 0)[0];
  }

  /// Coefficients of the polynomials: entry (k, p) is the coefficient of x^p in h_k.
  Eigen::MatrixXd monomial_coefficients() const;

 private:
  std::vector<double> centre_;  // a_i
  std::vector<double> norm_;    // b_i
};

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
