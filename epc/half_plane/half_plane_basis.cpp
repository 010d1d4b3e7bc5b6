#include "epc/half_plane/half_plane_basis.hpp"

#include <algorithm>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <vector>

namespace fpkcheck::epc::half_plane {

QuadraturePoints QuadraturePoints::zero_initialised(Eigen::Index count) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(count);
  return {.s = zero, .t = zero, .y = zero, .v = zero, .energy = zero, .weight = zero};
}

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

std::vector<Eigen::MatrixXd> OrthonormalPolynomials::polynomial_derivative_tables(
    const Eigen::VectorXd& x, int order) const {
  std::vector<Eigen::MatrixXd> tables(order + 1, Eigen::MatrixXd::Zero(x.size(), degree() + 1));
  tables[0].col(0).setOnes();
  for (int i = 0; i < degree(); ++i) {
    for (int j = 0; j <= order; ++j) {
      // The j-th derivative of (x - a) h(x) for a function h is (x - a) h^(j) + j h^(j-1).
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

OrthonormalBasis::OrthonormalBasis(int order, const QuadraturePoints& points,
                                   const Eigen::VectorXd& mass)
    : order_(order), of_s_(points.s, mass, order), of_t_(points.t, mass, order) {
  for (int m = 1; m <= order; ++m) {
    for (int q = 0; q <= m; ++q) members_.push_back({m - q, q});
  }
}

Eigen::MatrixXd products_of_basis_columns(
    const std::vector<OrthonormalBasis::BasisFunction>& basis_functions,
    const Eigen::MatrixXd& s_table, const Eigen::MatrixXd& t_table) {
  Eigen::MatrixXd result(s_table.rows(), static_cast<Eigen::Index>(basis_functions.size()));
  for (std::size_t k = 0; k < basis_functions.size(); ++k) {
    result.col(static_cast<Eigen::Index>(k)) =
        s_table.col(basis_functions[k].p).cwiseProduct(t_table.col(basis_functions[k].q));
  }
  return result;
}

Eigen::MatrixXd OrthonormalBasis::basis_values(const Eigen::VectorXd& s,
                                               const Eigen::VectorXd& t) const {
  return products_of_basis_columns(members_, of_s_.polynomial_values(s),
                                   of_t_.polynomial_values(t));
}

BasisValuesAtPoints::BasisValuesAtPoints(const OrthonormalBasis& basis, const Eigen::VectorXd& s,
                                         const Eigen::VectorXd& t)
    : members_(basis.basis_functions()), g_(basis.polynomials_in_t().polynomial_values(t)) {
  members_.insert(members_.begin(), {0, 0});
  std::vector<double> s_of_lines;
  for (Eigen::Index i = 0; i < s.size(); ++i) {
    if (i > 0 && s[i] == s_of_lines.back()) continue;
    line_begins_.push_back(i);
    s_of_lines.push_back(s[i]);
  }
  line_begins_.push_back(s.size());
  h_ = basis.polynomials_in_s().polynomial_values(
      Eigen::Map<const Eigen::VectorXd>(s_of_lines.data(), std::ssize(s_of_lines)));
}

Eigen::VectorXd BasisValuesAtPoints::basis_function_combination(const Eigen::VectorXd& a) const {
  Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(g_.cols(), h_.cols());
  for (Eigen::Index k = 0; k < size(); ++k)
    coefficients(members_[k + 1].q, members_[k + 1].p) = a[k];
  const Eigen::MatrixXd of_lines = coefficients * h_.transpose();
  Eigen::VectorXd result(g_.rows());
  for (Eigen::Index line = 0; line < constant_s_line_count(); ++line) {
    result.segment(line_begins_[line], point_count_on_constant_s_line(line)).noalias() =
        t_polynomials_on_line(line) * of_lines.col(line);
  }
  return result;
}

Eigen::VectorXd BasisValuesAtPoints::basis_means_under_mass(const Eigen::VectorXd& mass) const {
  Eigen::MatrixXd g_means(g_.cols(), constant_s_line_count());
  for (Eigen::Index line = 0; line < constant_s_line_count(); ++line) {
    g_means.col(line).noalias() =
        t_polynomials_on_line(line).transpose() * values_on_constant_s_line(mass, line);
  }
  const Eigen::MatrixXd all = g_means * h_;
  Eigen::VectorXd result(size());
  for (Eigen::Index k = 0; k < size(); ++k) result[k] = all(members_[k + 1].q, members_[k + 1].p);
  return result;
}

Eigen::MatrixXd BasisValuesAtPoints::basis_second_moments(const Eigen::VectorXd& mass) const {
  const auto count = static_cast<Eigen::Index>(members_.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(count, count);
  Eigen::MatrixXd g_products(g_.cols(), g_.cols()), weighted;
  for (Eigen::Index line = 0; line < constant_s_line_count(); ++line) {
    weighted = values_on_constant_s_line(mass, line).asDiagonal() * t_polynomials_on_line(line);
    g_products.noalias() = t_polynomials_on_line(line).transpose() * weighted;
    for (Eigen::Index k = 0; k < count; ++k) {
      const double h_k = h_(line, members_[k].p);
      const double* const g_k = g_products.col(members_[k].q).data();
      for (Eigen::Index j = k; j < count; ++j)
        result(j, k) += h_k * h_(line, members_[j].p) * g_k[members_[j].q];
    }
  }
  return result.selfadjointView<Eigen::Lower>();
}

Eigen::MatrixXd BasisValuesAtPoints::basis_mean_products(const Eigen::MatrixXd& values,
                                                         const Eigen::VectorXd& mass) const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(values.cols(), size());
  Eigen::MatrixXd g_products(values.cols(), g_.cols()), weighted;
  for (Eigen::Index line = 0; line < constant_s_line_count(); ++line) {
    weighted = values_on_constant_s_line(mass, line).asDiagonal() * t_polynomials_on_line(line);
    g_products.noalias() =
        values.middleRows(line_begins_[line], point_count_on_constant_s_line(line)).transpose() *
        weighted;
    for (Eigen::Index k = 0; k < size(); ++k)
      result.col(k) += h_(line, members_[k + 1].p) * g_products.col(members_[k + 1].q);
  }
  return result;
}

ExponentPolynomial OrthonormalBasis::exponent_polynomial(const Eigen::VectorXd& a) const {
  Eigen::MatrixXd basis_functions = Eigen::MatrixXd::Zero(order_ + 1, order_ + 1);
  for (Eigen::Index k = 0; k < size(); ++k) basis_functions(members_[k].p, members_[k].q) = a[k];
  const Eigen::MatrixXd monomials =
      of_s_.monomial_coefficients().transpose() * basis_functions * of_t_.monomial_coefficients();
  std::vector<ExponentMonomial> terms;
  for (const auto& [p, q] : members_) terms.push_back({p, q, monomials(p, q)});
  return ExponentPolynomial(std::move(terms));
}

}  // namespace fpkcheck::epc::half_plane
