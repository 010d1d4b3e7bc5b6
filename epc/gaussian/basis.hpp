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

/// Deviations sigma_1 and sigma_2 of the weights f1 and f2 of paper (25)-(26). In the paper's class
/// they are those of equivalent linearisation, else root mean squares by energy averaging.
Deviations deviations(const problem::Problem& problem);

/// Basis functions and their derivatives at points: point i in row i, function s in column s. d22
/// is the second derivative in x2, and so on.
struct BasisTable {
  Eigen::MatrixXd value, d1, d2, d22, d222, d2222;
};

/// Basis of monomials x1^p x2^q / N_pq of Q_n with unit norm under the weights,
/// N_pq^2 = E[x1^2p x2^2q] = sigma_1^2p (2p-1)!! sigma_2^2q (2q-1)!!.
class Basis {
 public:
  Basis(int order, MonomialSet set, const Deviations& sigma);

  int order() const { return order_; }
  MonomialSet set() const { return set_; }
  const Deviations& sigma() const { return sigma_; }
  Eigen::Index size() const { return static_cast<Eigen::Index>(members_.size()); }

  double value(Eigen::Index s, double x1, double x2) const;
  /// Basis functions at the points (x1[i], x2[i]): point i in row i, function s in column s.
  Eigen::MatrixXd values(const Eigen::VectorXd& x1, const Eigen::VectorXd& x2) const;
  /// Basis functions and their derivatives at the points (x1[i], x2[i]).
  BasisTable table(const Eigen::VectorXd& x1, const Eigen::VectorXd& x2) const;

  /// Q_n in physical monomials, from its coefficients in the basis.
  Polynomial polynomial(const Eigen::VectorXd& scaled_coefficients) const;
  /// Coefficients of a polynomial in the basis; terms outside the basis are ignored.
  Eigen::VectorXd scaled_coefficients(const std::vector<Term>& terms) const;

 private:
  /// Basis functions as products of columns: powers of x1 and of x2, or their derivatives.
  Eigen::MatrixXd products(const Eigen::MatrixXd& of_x1, const Eigen::MatrixXd& of_x2) const;

  struct Member {
    int p, q;
    double norm;
  };
  int order_;
  MonomialSet set_;
  Deviations sigma_;
  std::vector<Member> members_;
};

}  // namespace fpkcheck::epc::gaussian
