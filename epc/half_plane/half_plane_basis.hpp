#pragma once

#include <Eigen/Core>
#include <vector>

#include "epc/form/exponent_polynomial.hpp"

namespace fpkcheck::epc::half_plane {

/// Numbers of quadrature points in the coordinates s and t of a closure, and on each wall.
struct QuadraturePointCounts {
  int s, t, wall;
};

/// Points and weights of a quadrature rule on the half-plane y >= 0 of displacement and velocity.
/// The coordinates s and t are the variables of the polynomial Q_n of the closure: The pair (s, t)
/// is (y, v) in the formulation moment, (rho, theta) in polar, and (rho, v) in contact, with
/// amplitude rho and phase theta.
struct QuadraturePoints {
  Eigen::VectorXd s, t;
  Eigen::VectorXd y, v;
  Eigen::VectorXd energy;  ///< energy h, the argument of the confinement
  Eigen::VectorXd weight;

  static QuadraturePoints zero_initialised(Eigen::Index count);
  Eigen::Index size() const { return weight.size(); }
};

/// Polynomials h_0 = 1, h_1 .. h_n of one variable x that are orthonormal under a discrete measure,
/// by Stieltjes' procedure,
///
///     b_i h_{i+1}(x) = (x - a_i) h_i(x) - b_{i-1} h_{i-1}(x).
///
/// The discrete measure under which the polynomials are orthonormal approximates a marginal
/// density. Hermite polynomials of high order would lose accuracy on y >= 0 by cancellation.
class OrthonormalPolynomials {
 public:
  /// @param points,weights points and weights of the discrete measure. The sum of the weights of
  /// the discrete measure is 1, and more than `degree` points are distinct.
  OrthonormalPolynomials(const Eigen::VectorXd& points, const Eigen::VectorXd& weights, int degree);

  int degree() const { return static_cast<int>(centre_.size()); }

  /// Returns tables of the polynomials h_k and their derivatives: entry [j](i, k) is the j-th
  /// derivative of h_k at the point x_i.
  /// @param highest_derivative largest order j of a derivative
  std::vector<Eigen::MatrixXd> polynomial_derivative_tables(const Eigen::VectorXd& x,
                                                            int highest_derivative) const;
  /// Returns the values of the polynomials h_k at points x_i: entry (i, k) is h_k(x_i).
  Eigen::MatrixXd polynomial_values(const Eigen::VectorXd& x) const {
    return polynomial_derivative_tables(x, 0)[0];
  }

  /// Returns the monomial coefficients of the polynomials h_k: entry (k, p) is the coefficient of
  /// x^p in h_k.
  Eigen::MatrixXd monomial_coefficients() const;

 private:
  std::vector<double> centre_;  // coefficients a_i of the recurrence
  std::vector<double> norm_;    // coefficients b_i of the recurrence
};

/// Basis of the products h_p(s) g_q(t) of polynomials, 1 <= p + q <= n, in the coordinates s and t
/// of QuadraturePoints. The polynomials h_p and g_q of the basis are orthonormal under the marginal
/// densities of an approximate density.
class OrthonormalBasis {
 public:
  struct BasisFunction {
    int p, q;
  };

  /// @param points quadrature points of the domain
  /// @param mass probability of the approximate density at each quadrature point; the sum is 1
  OrthonormalBasis(int order, const QuadraturePoints& points, const Eigen::VectorXd& mass);

  int order() const { return order_; }
  Eigen::Index size() const { return static_cast<Eigen::Index>(members_.size()); }
  const std::vector<BasisFunction>& basis_functions() const { return members_; }
  const OrthonormalPolynomials& polynomials_in_s() const { return of_s_; }
  const OrthonormalPolynomials& polynomials_in_t() const { return of_t_; }

  Eigen::MatrixXd basis_values(const Eigen::VectorXd& s, const Eigen::VectorXd& t) const;

  /// Returns the exponent Q_n as a sum of monomials of s and t, from the coefficients in the basis.
  ExponentPolynomial exponent_polynomial(const Eigen::VectorXd& coefficients) const;

 private:
  int order_;
  std::vector<BasisFunction> members_;
  OrthonormalPolynomials of_s_, of_t_;
};

/// Values of the basis functions at quadrature points. Consecutive quadrature points of equal
/// coordinate s form a line, on which each polynomial h_p(s) is constant. The sums over the
/// quadrature points of a line contain only the n + 1 polynomials g_q(t) instead of the (n + 1)(n +
/// 2)/2 - 1 basis functions (sum factorisation). For lines of at least n points, sum factorisation
/// reduces the operations of basis_second_moments() by a factor of about n^2/4.
class BasisValuesAtPoints {
 public:
  /// @param s,t coordinates of the quadrature points; points of equal s are consecutive
  BasisValuesAtPoints(const OrthonormalBasis& basis, const Eigen::VectorXd& s,
                      const Eigen::VectorXd& t);

  Eigen::Index size() const { return static_cast<Eigen::Index>(members_.size()) - 1; }

  /// Returns the sum of all basis functions phi_k times coefficients a_k at the quadrature points.
  Eigen::VectorXd basis_function_combination(const Eigen::VectorXd& a) const;
  /// Returns the sum over the quadrature points of mass times phi_k, for each basis function phi_k.
  Eigen::VectorXd basis_means_under_mass(const Eigen::VectorXd& mass) const;
  /// Returns the sum over the quadrature points of mass times phi_j phi_k in row j and column k,
  /// for all pairs of basis functions. Row 0 and column 0 of the matrix belong to the constant
  /// function 1; the following rows and columns belong to the basis functions.
  Eigen::MatrixXd basis_second_moments(const Eigen::VectorXd& mass) const;
  /// Returns the sum over the quadrature points of values_j mass phi_k in row j and column k, for
  /// all basis functions phi_k.
  /// @param values matrix of shape (points, any number of columns)
  Eigen::MatrixXd basis_mean_products(const Eigen::MatrixXd& values,
                                      const Eigen::VectorXd& mass) const;

 private:
  Eigen::Index constant_s_line_count() const { return h_.rows(); }
  Eigen::Index point_count_on_constant_s_line(Eigen::Index line) const {
    return line_begins_[line + 1] - line_begins_[line];
  }
  // Returns the values of the polynomials g_q(t) at the quadrature points of a line, of shape
  // (points, degree + 1).
  auto t_polynomials_on_line(Eigen::Index line) const {
    return g_.middleRows(line_begins_[line], point_count_on_constant_s_line(line));
  }
  auto values_on_constant_s_line(const Eigen::VectorXd& values, Eigen::Index line) const {
    return values.segment(line_begins_[line], point_count_on_constant_s_line(line));
  }

  std::vector<OrthonormalBasis::BasisFunction>
      members_;                            // the function 1, then the basis functions
  std::vector<Eigen::Index> line_begins_;  // first point of each line, then the point count
  Eigen::MatrixXd h_;                      // h_p(s), of shape (lines, degree + 1)
  Eigen::MatrixXd g_;                      // g_q(t), of shape (points, degree + 1)
};

/// Returns products of column p_k of `s_table` and column q_k of `t_table` for all functions k.
Eigen::MatrixXd products_of_basis_columns(
    const std::vector<OrthonormalBasis::BasisFunction>& basis_functions,
    const Eigen::MatrixXd& s_table, const Eigen::MatrixXd& t_table);

}  // namespace fpkcheck::epc::half_plane
