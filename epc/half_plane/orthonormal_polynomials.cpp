#include "epc/half_plane/orthonormal_polynomials.hpp"

#include <cmath>

namespace fpkcheck::epc::half_plane {

OrthonormalPolynomials::OrthonormalPolynomials(const Eigen::VectorXd& points,
                                               const Eigen::VectorXd& weights, int degree) {
  Eigen::VectorXd before = Eigen::VectorXd::Zero(points.size());
  Eigen::VectorXd h = Eigen::VectorXd::Ones(points.size());
  for (int i = 0; i < degree; ++i) {
    centre_.push_back((weights.array() * h.array().square() * points.array()).sum());
    Eigen::VectorXd next = (points.array() - centre_[i]) * h.array();
    if (i > 0) next -= norm_[i - 1] * before;
    norm_.push_back(std::sqrt((weights.array() * next.array().square()).sum()));
    before = h;
    h = next / norm_[i];
  }
}

std::vector<Eigen::MatrixXd> OrthonormalPolynomials::derivative_tables(const Eigen::VectorXd& x,
                                                                       int order) const {
  std::vector<Eigen::MatrixXd> tables(order + 1, Eigen::MatrixXd::Zero(x.size(), degree() + 1));
  tables[0].col(0).setOnes();
  for (int i = 0; i < degree(); ++i) {
    for (int j = 0; j <= order; ++j) {
      // The j-th derivative of (x - a) h is (x - a) h^(j) + j h^(j-1).
      Eigen::VectorXd next = (x.array() - centre_[i]) * tables[j].col(i).array();
      if (j > 0) next += j * tables[j - 1].col(i);
      if (i > 0) next -= norm_[i - 1] * tables[j].col(i - 1);
      tables[j].col(i + 1) = next / norm_[i];
    }
  }
  return tables;
}

Eigen::MatrixXd OrthonormalPolynomials::monomial_coefficients() const {
  const int n = degree();
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(n + 1, n + 1);
  c(0, 0) = 1;
  for (int i = 0; i < n; ++i) {
    c.row(i + 1).tail(n) = c.row(i).head(n);
    c.row(i + 1) -= centre_[i] * c.row(i);
    if (i > 0) c.row(i + 1) -= norm_[i - 1] * c.row(i - 1);
    c.row(i + 1) /= norm_[i];
  }
  return c;
}

}  // namespace fpkcheck::epc::half_plane
