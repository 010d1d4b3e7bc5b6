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

/// sigma_1 and sigma_2, the deviations of the weights f1 and f2 of paper (25)-(26): of equivalent
/// linearisation in the paper's class, else of energy averaging, from 0.
Deviations deviations(const problem::Problem& problem);

/// Basis functions at points: point i in row i, function s in column s. Two twos stand for the
/// second derivative in x2, and so on.
struct BasisTable {
  Eigen::MatrixXd value, d1, d2, d22, d222, d2222;
};

/// The monomials x1^p x2^q / N_pq of Q_n, scaled by their norm in the weights,
/// N_pq^2 = E[x1^2p x2^2q] = sigma_1^2p (2p-1)!! sigma_2^2q (2q-1)!!.
class Basis {
 public:
  Basis(int order, MonomialSet set, const Deviations& sigma);

  int order() const { return order_; }
  MonomialSet set() const { return set_; }
  const Deviations& sigma() const { return sigma_; }
  Eigen::Index size() const { return static_cast<Eigen::Index>(members_.size()); }

  double value(Eigen::Index s, double x1, double x2) const;
  /// The basis functions at the points (x1[i], x2[i]): point i in row i, function s in column s.
  Eigen::MatrixXd values(const Eigen::VectorXd& x1, const Eigen::VectorXd& x2) const;
  /// The basis functions and their derivatives at the points (x1[i], x2[i]).
  BasisTable table(const Eigen::VectorXd& x1, const Eigen::VectorXd& x2) const;

  /// Q_n of the scaled coefficients, in physical monomials.
  Polynomial polynomial(const Eigen::VectorXd& scaled) const;
  /// The scaled coefficients of a polynomial; terms outside the basis are left out.
  Eigen::VectorXd scaled(const std::vector<Term>& terms) const;

 private:
  /// Products of a power of x1 and one of x2, or of their derivatives, each given by columns.
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
