#include "epc/basis.hpp"

#include <boost/math/special_functions/factorials.hpp>
#include <cmath>

namespace fpkcheck::epc {
namespace {

// sqrt(E[x^2p]) of a normal variable.
double norm(int p, double sigma) {
  const double moment =
      p == 0 ? 1 : boost::math::double_factorial<double>(static_cast<unsigned>(2 * p - 1));
  return std::pow(sigma, p) * std::sqrt(moment);
}

// The j-th derivative of x^p.
double monomial_derivative(int p, int j, double x) {
  double factor = 1;
  for (int i = 0; i < j; ++i) factor *= p - i;
  return factor == 0 ? 0 : factor * std::pow(x, p - j);
}

}  // namespace

Deviations deviations(const problem::EquivalentLinearisation& linear) {
  return {linear.displacement_deviation, linear.velocity_deviation};
}

Basis::Basis(int order, MonomialSet set, const Deviations& sigma) : order_(order), sigma_(sigma) {
  const int step = set == MonomialSet::point_symmetric ? 2 : 1;
  for (int m = step; m <= order; m += step) {
    for (int l = 0; l <= m; ++l) {
      members_.push_back({m - l, l, norm(m - l, sigma.x1) * norm(l, sigma.x2)});
    }
  }
}

double Basis::value(Eigen::Index s, double x1, double x2) const {
  const auto& [p, q, norm] = members_[s];
  return std::pow(x1, p) * std::pow(x2, q) / norm;
}

Derivatives Basis::derivatives(Eigen::Index s, double x1, double x2) const {
  const auto& [p, q, norm] = members_[s];
  const double along_x1 = std::pow(x1, p) / norm;
  return {.q1 = monomial_derivative(p, 1, x1) * std::pow(x2, q) / norm,
          .q2 = along_x1 * monomial_derivative(q, 1, x2),
          .q22 = along_x1 * monomial_derivative(q, 2, x2),
          .q222 = along_x1 * monomial_derivative(q, 3, x2),
          .q2222 = along_x1 * monomial_derivative(q, 4, x2)};
}

Polynomial Basis::polynomial(const Eigen::VectorXd& scaled) const {
  std::vector<Term> terms;
  for (Eigen::Index s = 0; s < size(); ++s) {
    terms.push_back({members_[s].p, members_[s].q, scaled[s] / members_[s].norm});
  }
  return Polynomial(std::move(terms));
}

Eigen::VectorXd Basis::scaled(const std::vector<Term>& terms) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(size());
  for (Eigen::Index s = 0; s < size(); ++s) {
    for (const auto& [p, q, a] : terms) {
      if (p == members_[s].p && q == members_[s].q) result[s] += a * members_[s].norm;
    }
  }
  return result;
}

}  // namespace fpkcheck::epc
