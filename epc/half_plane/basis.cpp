#include "epc/half_plane/basis.hpp"

namespace fpkcheck::epc::half_plane {

Basis::Basis(int order, const QuadraturePoints& points, const Eigen::VectorXd& mass)
    : order_(order), of_s_(points.s, mass, order), of_t_(points.t, mass, order) {
  for (int m = 1; m <= order; ++m) {
    for (int q = 0; q <= m; ++q) members_.push_back({m - q, q});
  }
}

Eigen::MatrixXd products_of_tables(const std::vector<Basis::BasisFunction>& members,
                                   const Eigen::MatrixXd& s_table, const Eigen::MatrixXd& t_table) {
  Eigen::MatrixXd result(s_table.rows(), static_cast<Eigen::Index>(members.size()));
  for (std::size_t k = 0; k < members.size(); ++k) {
    result.col(static_cast<Eigen::Index>(k)) =
        s_table.col(members[k].p).cwiseProduct(t_table.col(members[k].q));
  }
  return result;
}

Eigen::MatrixXd Basis::basis_values(const Eigen::VectorXd& s, const Eigen::VectorXd& t) const {
  return products_of_tables(members_, of_s_.polynomial_values(s), of_t_.polynomial_values(t));
}

Polynomial Basis::exponent_polynomial(const Eigen::VectorXd& a) const {
  Eigen::MatrixXd members = Eigen::MatrixXd::Zero(order_ + 1, order_ + 1);
  for (Eigen::Index k = 0; k < size(); ++k) members(members_[k].p, members_[k].q) = a[k];
  const Eigen::MatrixXd monomials =
      of_s_.monomial_coefficients().transpose() * members * of_t_.monomial_coefficients();
  std::vector<Term> terms;
  for (const auto& [p, q] : members_) terms.push_back({p, q, monomials(p, q)});
  return Polynomial(std::move(terms));
}

}  // namespace fpkcheck::epc::half_plane
