#include "epc/gaussian/jump_remainder.hpp"

#include <cmath>
#include <numbers>

#include "epc/gaussian/impulse_rule.hpp"
#include "numerics/quadrature/gauss_panels.hpp"
#include "problem/impulse_train.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

// Number of ten-point panels in each of radius and angle on a half-plane.
constexpr int kPanels = 3;
// Number of points of the quadrature rule of the impulse law.
constexpr int kJumpPoints = 20;

// Quadrature rule with the weights f1 f2 on both half-discs; x1 has one sign on each half-disc. For
// a point-symmetric integrand both half-discs give the same integral, and the rule uses one of
// them.
PlaneRule disc(const Deviations& sigma, double radius, bool symmetric) {
  const double half_turn = std::numbers::pi / 2;
  PlaneRule rule;
  for (const auto& [rho, rho_weight] : numerics::panel_points(0, radius, kPanels)) {
    const double ring = rho_weight * rho * std::exp(-rho * rho / 2) / (2 * std::numbers::pi);
    for (const auto& [angle, width] : numerics::panel_points(-half_turn, half_turn, kPanels)) {
      const double x1 = sigma.x1 * rho * std::cos(angle), x2 = sigma.x2 * rho * std::sin(angle);
      rule.add(x1, x2, (symmetric ? 2 : 1) * ring * width);
      if (!symmetric) rule.add(-x1, -x2, ring * width);
    }
  }
  return rule;
}

RateMoments series_terms(const problem::ImpulseTrain& impulses) {
  RateMoments moments{};
  for (int j = 1; j <= 4; ++j) moments[j] = impulses.rate_moment(j);
  return moments;
}

}  // namespace

JumpRemainder::JumpRemainder(const Basis& basis, const problem::ImpulseTrain& impulses,
                             double radius)
    : rate_(impulses.arrival_rate()),
      series_(series_terms(impulses)),
      nodes_(disc(basis.sigma(), radius, basis.set() == MonomialSet::point_symmetric), basis) {
  const QuadratureRule law = impulse_rule(impulses.law(), kJumpPoints);
  jumps_ = static_cast<Eigen::Index>(law.nodes.size());
  Eigen::VectorXd x1(nodes_.size() * jumps_), x2(x1.size());
  jump_weights_.resize(x1.size());
  const auto& [sigma1, sigma2] = basis.sigma();
  for (Eigen::Index i = 0; i < nodes_.size(); ++i) {
    for (Eigen::Index j = 0; j < jumps_; ++j) {
      const Eigen::Index row = i * jumps_ + j;
      x1[row] = nodes_.x1(i);
      x2[row] = nodes_.x2(i) - side(i) * law.nodes[j];
      const bool reached = std::hypot(x1[row] / sigma1, x2[row] / sigma2) < radius + kJumpMargin;
      jump_weights_[row] = reached ? law.weights[j] : 0;
    }
  }
  increments_ = basis.values(x1, x2);
  for (Eigen::Index i = 0; i < nodes_.size(); ++i) {
    increments_.middleRows(i * jumps_, jumps_).rowwise() -= nodes_.basis().value.row(i);
  }
}

Eigen::VectorXd JumpRemainder::density_ratios(const Eigen::VectorXd& a) const {
  return jump_weights_.array() * (increments_ * a).array().exp();
}

Eigen::VectorXd JumpRemainder::projection(const Eigen::VectorXd& a) const {
  const Eigen::VectorXd weighted = density_ratios(a);
  const std::vector<Derivatives> q = nodes_.exponent_derivatives(a);
  return nodes_.project(Eigen::VectorXd::NullaryExpr(nodes_.size(), [&](Eigen::Index i) {
                          const double expectation = weighted.segment(i * jumps_, jumps_).sum();
                          return rate_ * (expectation - 1) - series_part(series_, side(i), q[i]);
                        }).eval());
}

Eigen::MatrixXd JumpRemainder::jacobian(const Eigen::VectorXd& a) const {
  const Eigen::VectorXd weighted = density_ratios(a);
  Eigen::MatrixXd rows(nodes_.size(), a.size());
  for (Eigen::Index i = 0; i < nodes_.size(); ++i) {
    rows.row(i).noalias() = rate_ * weighted.segment(i * jumps_, jumps_).transpose() *
                            increments_.middleRows(i * jumps_, jumps_);
  }
  std::vector<Derivatives> series = nodes_.exponent_derivatives(a);
  for (Eigen::Index i = 0; i < nodes_.size(); ++i)
    series[i] = series_gradient(series_, side(i), series[i]);
  return nodes_.project(rows) - nodes_.project_gradients(series);
}

}  // namespace fpkcheck::epc::gaussian
