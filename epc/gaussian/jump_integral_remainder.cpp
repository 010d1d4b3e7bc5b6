#include "epc/gaussian/jump_integral_remainder.hpp"

#include <cmath>
#include <numbers>
#include <variant>

#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/excitation.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::epc::gaussian {

using numerics::QuadratureRule;

namespace {

QuadratureRule quadrature_rule_of(const problem::GaussianLaw& law, int points) {
  QuadratureRule rule = numerics::gauss_hermite_rule(2 * points - 1);
  for (double& y : rule.points) y = law.mean + law.deviation * y;
  return rule;
}

QuadratureRule quadrature_rule_of(const problem::LaplaceLaw& law, int points) {
  const QuadratureRule half = numerics::gauss_laguerre_rule(2 * points - 1);
  QuadratureRule rule{{}, Eigen::VectorXd(2 * half.size())};
  for (Eigen::Index i = 0; i < half.size(); ++i) {
    for (const int side : {-1, 1})
      rule.points.push_back(law.mean + side * law.scale * half.points[i]);
    rule.weights.segment<2>(2 * i).setConstant(half.weights[i] / 2);
  }
  return rule;
}

QuadratureRule quadrature_rule_of(const problem::ExponentialLaw& law, int points) {
  QuadratureRule rule = numerics::gauss_laguerre_rule(2 * points - 1);
  for (double& y : rule.points) y = law.mean + law.scale * (y - 1);
  return rule;
}

QuadratureRule quadrature_rule_of(const problem::TwoPointLaw& law, int) {
  return {.points = {law.mean - law.deviation, law.mean + law.deviation},
          .weights = Eigen::Vector2d(0.5, 0.5)};
}

QuadratureRule quadrature_rule_of(const problem::UniformLaw& law, int points) {
  QuadratureRule rule =
      numerics::gauss_legendre_rule(points, law.mean - law.half_width, law.mean + law.half_width);
  rule.weights /= 2 * law.half_width;
  return rule;
}

}  // namespace

QuadratureRule impulse_quadrature_rule(const problem::ImpulseLaw& law, int points) {
  return std::visit(
      [&](const auto& kind) {
        if constexpr (requires { quadrature_rule_of(kind, points); }) {
          return quadrature_rule_of(kind, points);
        } else {
          return piecewise_impulse_quadrature_rule(law);
        }
      },
      law.law_variant());
}

QuadratureRule piecewise_impulse_quadrature_rule(const problem::ImpulseLaw& law) {
  std::vector<double> points, probabilities;
  const auto add = [&](double amplitude, double probability) {
    points.push_back(amplitude);
    probabilities.push_back(probability);
  };
  for (const auto& [amplitude, probability] : law.amplitude_atoms()) add(amplitude, probability);
  const std::vector<double> pieces = law.amplitude_density_breakpoints();
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const double from = pieces[i], to = pieces[i + 1];
    const int panels =
        static_cast<int>(std::ceil((to - from) / law.amplitude_standard_deviation()));
    for (const auto& [at, weight] : numerics::composite_gauss_points(from, to, panels)) {
      add(at, weight * law.density(at));
    }
  }
  return {points,
          Eigen::Map<const Eigen::VectorXd>(probabilities.data(), std::ssize(probabilities))};
}

namespace {

// Number of quadrature panels, with ten points each, in the radius and in the angle of a half-disc.
constexpr int kPanels = 3;
constexpr int kJumpPoints = 20;

// Returns a quadrature rule with the Gaussian weights f1 f2 on two half-discs, each with one sign
// of x1. For a function that is even under (x1, x2) -> (-x1, -x2) the quadrature rule uses one
// half-disc with doubled weights.
PlaneQuadratureRule disc_rule(const StandardDeviations& sigma, double radius, bool symmetric) {
  const double half_turn = std::numbers::pi / 2;
  PlaneQuadratureRule rule;
  for (const auto& [rho, rho_weight] : numerics::composite_gauss_points(0, radius, kPanels)) {
    const double ring = rho_weight * rho * std::exp(-rho * rho / 2) / (2 * std::numbers::pi);
    for (const auto& [angle, width] :
         numerics::composite_gauss_points(-half_turn, half_turn, kPanels)) {
      const double x1 = sigma.x1 * rho * std::cos(angle), x2 = sigma.x2 * rho * std::sin(angle);
      rule.add_quadrature_point(x1, x2, (symmetric ? 2 : 1) * ring * width);
      if (!symmetric) rule.add_quadrature_point(-x1, -x2, ring * width);
    }
  }
  return rule;
}

RateTimesMoments series_terms(const problem::ImpulseTrain& impulses) {
  RateTimesMoments moments{};
  for (int j = 1; j <= 4; ++j) moments[j] = impulses.rate_times_moment(j);
  return moments;
}

}  // namespace

JumpIntegralRemainder::JumpIntegralRemainder(const GaussianWeightedBasis& basis,
                                             const problem::ImpulseTrain& impulses, double radius)
    : rate_(impulses.arrival_rate()),
      series_(series_terms(impulses)),
      nodes_(disc_rule(basis.weight_standard_deviations(), radius,
                       basis.monomial_set() == MonomialSet::point_symmetric),
             basis) {
  const QuadratureRule law = impulse_quadrature_rule(impulses.amplitude_law(), kJumpPoints);
  jumps_ = law.size();
  Eigen::VectorXd x1(nodes_.size() * jumps_), x2(x1.size());
  jump_weights_.resize(x1.size());
  const auto& [sigma1, sigma2] = basis.weight_standard_deviations();
  for (Eigen::Index i = 0; i < nodes_.size(); ++i) {
    for (Eigen::Index j = 0; j < jumps_; ++j) {
      const Eigen::Index row = i * jumps_ + j;
      x1[row] = nodes_.x1(i);
      x2[row] = nodes_.x2(i) - sign_of_node_x1(i) * law.points[j];
      const bool reached = std::hypot(x1[row] / sigma1, x2[row] / sigma2) < radius + kJumpMargin;
      jump_weights_[row] = reached ? law.weights[j] : 0;
    }
  }
  increments_ = basis.basis_values(x1, x2);
  for (Eigen::Index i = 0; i < nodes_.size(); ++i) {
    increments_.middleRows(i * jumps_, jumps_).rowwise() -= nodes_.basis().value.row(i);
  }
}

Eigen::VectorXd JumpIntegralRemainder::weighted_jump_density_ratios(
    const Eigen::VectorXd& a) const {
  return jump_weights_.array() * (increments_ * a).array().exp();
}

Eigen::VectorXd JumpIntegralRemainder::projected_remainder(const Eigen::VectorXd& a) const {
  const Eigen::VectorXd weighted = weighted_jump_density_ratios(a);
  const std::vector<ExponentPartialDerivatives> q = nodes_.exponent_derivatives(a);
  return nodes_.project_on_basis_functions(
      Eigen::VectorXd::NullaryExpr(nodes_.size(), [&](Eigen::Index i) {
        const double expectation = weighted.segment(i * jumps_, jumps_).sum();
        return rate_ * (expectation - 1) -
               kramers_moyal_residual_part(series_, sign_of_node_x1(i), q[i]);
      }).eval());
}

Eigen::MatrixXd JumpIntegralRemainder::jacobian(const Eigen::VectorXd& a) const {
  const Eigen::VectorXd weighted = weighted_jump_density_ratios(a);
  Eigen::MatrixXd rows(nodes_.size(), a.size());
  for (Eigen::Index i = 0; i < nodes_.size(); ++i) {
    rows.row(i).noalias() = rate_ * weighted.segment(i * jumps_, jumps_).transpose() *
                            increments_.middleRows(i * jumps_, jumps_);
  }
  std::vector<ExponentPartialDerivatives> series = nodes_.exponent_derivatives(a);
  for (Eigen::Index i = 0; i < nodes_.size(); ++i)
    series[i] = kramers_moyal_residual_gradient(series_, sign_of_node_x1(i), series[i]);
  return nodes_.project_on_basis_functions(rows) - nodes_.project_gradients_on_basis(series);
}

}  // namespace fpkcheck::epc::gaussian
