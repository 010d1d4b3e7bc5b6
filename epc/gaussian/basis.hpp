#pragma once

#include <Eigen/Core>
#include <vector>

#include "epc/form/polynomial.hpp"
#include "epc/form/rays.hpp"
#include "epc/options.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::gaussian {

/// Standard deviations sigma_1 and sigma_2 of the weights f1 and f2 of paper (25)-(26).
/// For the paper's oscillator equivalent linearisation gives the deviations. For other oscillators
/// they are root mean squares of y and v by energy averaging.
StandardDeviations weight_deviations(const problem::Problem& problem);

/// Values and derivatives of the basis functions at points: point i in row i, basis function s in
/// column s. d1 is the first derivative in x1, and d22 the second derivative in x2.
struct BasisDerivatives {
  Eigen::MatrixXd value, d1, d2, d22, d222, d2222;
};

/// Basis of Q_n: monomials x1^p x2^q / N_pq with unit norm under the Gaussian weights,
/// N_pq^2 = E[x1^2p x2^2q] = sigma_1^2p (2p-1)!! sigma_2^2q (2q-1)!!.
class Basis {
 public:
  Basis(int order, MonomialSet set, const StandardDeviations& sigma);

  int order() const { return order_; }
  MonomialSet monomial_set() const { return set_; }
  const StandardDeviations& sigma() const { return sigma_; }
  Eigen::Index size() const { return static_cast<Eigen::Index>(members_.size()); }

  /// Value of basis function s at a point.
  double basis_value(Eigen::Index s, double x1, double x2) const;
  /// Values of the basis functions at the points (x1[i], x2[i]): point i in row i, basis function s
  /// in column s.
  Eigen::MatrixXd basis_values(const Eigen::VectorXd& x1, const Eigen::VectorXd& x2) const;
  /// Values and derivatives of the basis functions at the points (x1[i], x2[i]).
  BasisDerivatives basis_derivatives(const Eigen::VectorXd& x1, const Eigen::VectorXd& x2) const;

  /// Q_n in unscaled monomials, from the coefficients of Q_n in the basis.
  Polynomial exponent_polynomial(const Eigen::VectorXd& scaled_coefficients) const;
  /// Coefficients of a polynomial in the basis; terms outside the basis are ignored.
  Eigen::VectorXd scaled_coefficients(const std::vector<Term>& terms) const;

 private:
  /// Table of the basis functions, or of a derivative, from tables of one variable: column p of
  /// `of_x1` times column q of `of_x2`, divided by the norm.
  Eigen::MatrixXd column_products(const Eigen::MatrixXd& of_x1, const Eigen::MatrixXd& of_x2) const;

  struct BasisFunction {
    int p, q;
    double norm;
  };
  int order_;
  MonomialSet set_;
  StandardDeviations sigma_;
  std::vector<BasisFunction> members_;
};

}  // namespace fpkcheck::epc::gaussian
