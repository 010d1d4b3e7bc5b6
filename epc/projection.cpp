#include "epc/projection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "epc/gaussian_rules.hpp"

namespace fpkcheck::epc {

Projection::Projection(Basis basis) : basis_(std::move(basis)) {
  const auto& [sigma1, sigma2] = basis_.sigma();
  const int n = basis_.order();
  // The degree of each part of F in x1 and in x2, Q_2 being of degree n-1, and of the projection
  // function.
  const int smooth_degree = std::max(4 * (n - 1), n + 2) + n;
  const int signed_degree = 3 * (n - 1) + n;
  const int impact_degree = n + n;

  const Rule plain = normal_rule(smooth_degree);
  for (std::size_t i = 0; i < plain.nodes.size(); ++i) {
    for (std::size_t j = 0; j < plain.nodes.size(); ++j) {
      smooth_.push_back(node(sigma1 * plain.nodes[i], sigma2 * plain.nodes[j],
                             plain.weights[i] * plain.weights[j]));
    }
  }
  const Rule sign = sign_rule(signed_degree);
  const Rule across = normal_rule(signed_degree);
  for (std::size_t i = 0; i < sign.nodes.size(); ++i) {
    for (std::size_t j = 0; j < across.nodes.size(); ++j) {
      signed_.push_back(node(sigma1 * sign.nodes[i], sigma2 * across.nodes[j],
                             sign.weights[i] * across.weights[j]));
    }
  }
  // int delta(x1) f1(x1) dx1 = f1(0), and |x2| = sigma_2 |u|.
  const double at_wall = 1 / (std::sqrt(2 * std::numbers::pi) * sigma1);
  const Rule absolute = absolute_rule(impact_degree);
  for (std::size_t j = 0; j < absolute.nodes.size(); ++j) {
    impact_.push_back(node(0, sigma2 * absolute.nodes[j], at_wall * sigma2 * absolute.weights[j]));
  }
}

Projection::Node Projection::node(double x1, double x2, double weight) const {
  Node result{x1, x2, Eigen::VectorXd(basis_.size()), {}};
  for (Eigen::Index s = 0; s < basis_.size(); ++s) {
    result.weighted_tests[s] = weight * basis_.value(s, x1, x2);
    result.members.push_back(basis_.derivatives(s, x1, x2));
  }
  return result;
}

Derivatives Projection::of_q(const Node& node, const Eigen::VectorXd& a) const {
  Derivatives q{0, 0, 0, 0, 0};
  for (Eigen::Index s = 0; s < basis_.size(); ++s) {
    const Derivatives& d = node.members[s];
    q.q1 += a[s] * d.q1;
    q.q2 += a[s] * d.q2;
    q.q22 += a[s] * d.q22;
    q.q222 += a[s] * d.q222;
    q.q2222 += a[s] * d.q2222;
  }
  return q;
}

Eigen::VectorXd Projection::residual(const ResidualCoefficients& f,
                                     const Eigen::VectorXd& a) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(basis_.size());
  for (const Node& at : smooth_) {
    result += smooth_part(f, at.x1, at.x2, of_q(at, a)) * at.weighted_tests;
  }
  for (const Node& at : signed_) result += signed_part(f, of_q(at, a)) * at.weighted_tests;
  for (const Node& at : impact_) result += impact_part(f, at.x2, of_q(at, a)) * at.weighted_tests;
  return result;
}

Eigen::MatrixXd Projection::jacobian(const ResidualCoefficients& f,
                                     const Eigen::VectorXd& a) const {
  const Eigen::Index size = basis_.size();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size, size);
  Eigen::RowVectorXd row(size);
  const auto add = [&](const Nodes& nodes, auto&& part_derivative) {
    for (const Node& at : nodes) {
      const Derivatives q = of_q(at, a);
      for (Eigen::Index k = 0; k < size; ++k) row[k] = part_derivative(at, q, at.members[k]);
      result.noalias() += at.weighted_tests * row;
    }
  };
  add(smooth_, [&](const Node& at, const Derivatives& q, const Derivatives& d) {
    return smooth_part_derivative(f, at.x1, at.x2, q, d);
  });
  add(signed_, [&](const Node&, const Derivatives& q, const Derivatives& d) {
    return signed_part_derivative(f, q, d);
  });
  add(impact_, [&](const Node& at, const Derivatives&, const Derivatives& d) {
    return impact_part_derivative(f, at.x2, d);
  });
  return result;
}

}  // namespace fpkcheck::epc
