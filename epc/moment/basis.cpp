#include "epc/moment/basis.hpp"

namespace fpkcheck::epc::moment {

Basis::Basis(int order, const Points& points, const Eigen::VectorXd& mass)
    : order_(order), of_y_(points.y, mass, order), of_v_(points.v, mass, order) {
  for (int m = 1; m <= order; ++m) {
    for (int q = 0; q <= m; ++q) members_.push_back({m - q, q});
  }
}

Eigen::MatrixXd products(const std::vector<Basis::Member>& members, const Eigen::MatrixXd& y_table,
                         const Eigen::MatrixXd& v_table) {
  Eigen::MatrixXd result(y_table.rows(), static_cast<Eigen::Index>(members.size()));
  for (std::size_t s = 0; s < members.size(); ++s) {
    result.col(static_cast<Eigen::Index>(s)) =
        y_table.col(members[s].p).cwiseProduct(v_table.col(members[s].q));
  }
  return result;
}

Eigen::MatrixXd Basis::values(const Eigen::VectorXd& y, const Eigen::VectorXd& v) const {
  return products(members_, of_y_.values(y), of_v_.values(v));
}

Polynomial Basis::polynomial(const Eigen::VectorXd& a) const {
  Eigen::MatrixXd members = Eigen::MatrixXd::Zero(order_ + 1, order_ + 1);
  for (Eigen::Index s = 0; s < size(); ++s) members(members_[s].p, members_[s].q) = a[s];
  const Eigen::MatrixXd monomials =
      of_y_.coefficients().transpose() * members * of_v_.coefficients();
  std::vector<Term> terms;
  for (const auto& [p, q] : members_) terms.push_back({p, q, monomials(p, q)});
  return Polynomial(std::move(terms));
}

}  // namespace fpkcheck::epc::moment
