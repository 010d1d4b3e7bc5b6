#pragma once

#include <vector>

#include <Eigen/Core>

namespace fpkcheck::epc::half_plane {

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

}  // namespace fpkcheck::epc::half_plane
