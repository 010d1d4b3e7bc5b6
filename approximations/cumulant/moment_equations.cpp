#include "approximations/cumulant/moment_equations.hpp"

#include <algorithm>
#include <boost/math/special_functions/binomial.hpp>
#include <boost/math/special_functions/factorials.hpp>
#include <cassert>
#include <cmath>

#include "approximations/cumulant/bivariate_polynomial.hpp"
#include "approximations/cumulant/gram_charlier.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "numerics/statistics.hpp"

namespace fpkcheck::cumulant {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using problem::ImpactCondition;

double binomial_coefficient(int n, int k) {
  return boost::math::binomial_coefficient<double>(static_cast<unsigned>(n),
                                                   static_cast<unsigned>(k));
}

// Largest i + j of a coefficient that is not 0.
int total_degree(const MatrixXd& coefficients) {
  int degree = 0;
  for (Index i = 0; i < coefficients.rows(); ++i) {
    for (Index j = 0; j < coefficients.cols(); ++j) {
      if (coefficients(i, j) != 0) degree = std::max(degree, static_cast<int>(i + j));
    }
  }
  return degree;
}

// Returns sum_ij a_ij E[y^(p+i) v^(q+j)].
double mean_of_product(const MatrixXd& coefficients, const MatrixXd& moments, int p, int q) {
  double mean = 0;
  for (Index i = 0; i < coefficients.rows(); ++i) {
    for (Index j = 0; j < coefficients.cols(); ++j) {
      if (coefficients(i, j) != 0) mean += coefficients(i, j) * moments(p + i, q + j);
    }
  }
  return mean;
}

// Unit of a standardised cumulant, for which unknowns are of similar sizes.
double cumulant_unit(int p, int q) {
  return std::sqrt(boost::math::factorial<double>(static_cast<unsigned>(p)) *
                   boost::math::factorial<double>(static_cast<unsigned>(q)));
}

}  // namespace

std::optional<PolynomialCoefficients> polynomial_coefficients(const problem::Problem& problem,
                                                              const problem::MotionScales& scales) {
  // Beyond kFittedDeviations the density hardly contributes to moments.
  constexpr double kFittedDeviations = 4;
  const bool has_wall = problem.system.left_wall().has_value();
  const double s_y = has_wall ? std::hypot(scales.centre, scales.displacement_deviation)
                              : scales.displacement_deviation;
  const double s_v = scales.velocity_deviation;
  const double centre = has_wall ? 0 : scales.centre / s_y;
  const Rectangle rectangle{.x_low = has_wall ? 0 : centre - kFittedDeviations,
                            .x_high = centre + kFittedDeviations,
                            .w_low = -kFittedDeviations,
                            .w_high = kFittedDeviations};
  const double time_unit = s_y / s_v;
  PolynomialCoefficients result{.displacement_unit = s_y, .velocity_unit = s_v};
  const auto force = fit_polynomial(
      [&](double y, double v) { return problem.system.force(s_y * y, s_v * v) * time_unit / s_v; },
      rectangle);
  const auto diffusion = fit_polynomial(
      [&](double y, double v) {
        return noise_diffusion_coefficient(problem, s_y * y, s_v * v) * time_unit / (s_v * s_v);
      },
      rectangle);
  const auto factor = fit_polynomial(
      [&](double y, double) {
        return problem.impulse_factor ? (*problem.impulse_factor)(s_y * y, 0) : 1.0;
      },
      rectangle);
  if (!force || !diffusion || !factor) return std::nullopt;
  result.force = *force;
  result.diffusion = *diffusion;
  const VectorXd b = factor->col(0);
  VectorXd power = VectorXd::Ones(1);  // coefficients of b^j
  for (int j = 1; j < problem::kMomentCount; ++j) {
    VectorXd next = VectorXd::Zero(power.size() + b.size() - 1);
    for (Index i = 0; i < b.size(); ++i) next.segment(i, power.size()) += b[i] * power;
    power = next;
    result.jump_moments[static_cast<std::size_t>(j)] =
        problem.impulses.rate_times_moment(j) * time_unit / std::pow(s_v, j) * power;
  }
  return result;
}

MatrixXd gram_charlier_polynomial(const Cumulants& cumulants) {
  const int order = cumulants.order();
  return gram_charlier_polynomial(moments_from_cumulants(cumulants.standardised, order), order);
}

MomentEquations::MomentEquations(const problem::Problem& problem, ImpactCondition impact,
                                 const PolynomialCoefficients& coefficients, int order)
    : problem_(problem),
      impact_(impact),
      coefficients_(coefficients),
      order_(order),
      has_wall_(problem.system.left_wall().has_value()) {
  assert(!problem.system.right_wall());
  max_moment_order_ = order - 1 + total_degree(coefficients.force);
  max_moment_order_ =
      std::max({max_moment_order_, order, order - 2 + total_degree(coefficients.diffusion)});
  for (int j = 1; j <= order; ++j) {
    max_moment_order_ =
        std::max(max_moment_order_,
                 order - j + total_degree(coefficients.jump_moments[static_cast<std::size_t>(j)]));
  }
  for (int p = 0; p <= order; ++p) {
    for (int q = 0; p + q <= order; ++q) {
      if (has_wall_ && (p + q) % 2 == 1) continue;
      if (q > 0) equations_.emplace_back(p, q);
      if (p + q > 2 && q != 1) free_cumulants_.emplace_back(p, q);
    }
  }
}

VectorXd MomentEquations::unknowns_of(const Cumulants& cumulants) const {
  std::vector<double> unknowns{
      std::log(cumulants.displacement_deviation / coefficients_.displacement_unit),
      std::log(cumulants.velocity_deviation / coefficients_.velocity_unit)};
  if (!has_wall_) {
    unknowns.push_back(cumulants.mean_displacement / coefficients_.displacement_unit);
  }
  for (const auto& [p, q] : free_cumulants_) {
    unknowns.push_back(
        p + q <= cumulants.order() ? cumulants.standardised(p, q) / cumulant_unit(p, q) : 0);
  }
  return VectorXd::Map(unknowns.data(), static_cast<Index>(unknowns.size()));
}

Cumulants MomentEquations::cumulants_of(const VectorXd& unknowns) const {
  const auto& [y_unit, v_unit, force, diffusion, jumps] = coefficients_;
  Cumulants cumulants{.mean_displacement = has_wall_ ? 0 : unknowns[2] * y_unit,
                      .displacement_deviation = std::exp(unknowns[0]) * y_unit,
                      .velocity_deviation = std::exp(unknowns[1]) * v_unit,
                      .standardised = MatrixXd::Zero(order_ + 1, order_ + 1)};
  cumulants.standardised(2, 0) = cumulants.standardised(0, 2) = 1;
  Index k = has_wall_ ? 2 : 3;
  for (const auto& [p, q] : free_cumulants_) {
    cumulants.standardised(p, q) = unknowns[k++] * cumulant_unit(p, q);
  }
  return cumulants;
}

// Returns the moments E[y^a y'^b] in the units of the coefficients.
MatrixXd MomentEquations::moments_of(const Cumulants& cumulants) const {
  const double s_y = cumulants.displacement_deviation / coefficients_.displacement_unit;
  const double s_v = cumulants.velocity_deviation / coefficients_.velocity_unit;
  MatrixXd scaled = cumulants.standardised;
  for (int p = 0; p <= order_; ++p) {
    for (int q = 0; q <= order_; ++q) scaled(p, q) *= std::pow(s_y, p) * std::pow(s_v, q);
  }
  scaled(1, 0) = cumulants.mean_displacement / coefficients_.displacement_unit;
  MatrixXd moments = moments_from_cumulants(scaled, max_moment_order_);
  if (!has_wall_) return moments;
  // E[y^a y'^b] = E[z^a z'^b sgn(z)^(a+b)]
  const MatrixXd polynomial = gram_charlier_polynomial(cumulants);
  for (int a = 0; a <= max_moment_order_; ++a) {
    for (int b = 0; a + b <= max_moment_order_; ++b) {
      if ((a + b) % 2 == 0) continue;
      moments(a, b) = std::pow(s_y, a) * std::pow(s_v, b) * half_plane_moment(polynomial, a, b);
    }
  }
  return moments;
}

double MomentEquations::impact_term(const Cumulants& cumulants, int q) const {
  constexpr int kPanels = 8;
  constexpr double kDeviations = 12;
  const double s_y = cumulants.displacement_deviation / coefficients_.displacement_unit;
  const double s_v = cumulants.velocity_deviation / coefficients_.velocity_unit;
  const MatrixXd polynomial = gram_charlier_polynomial(cumulants);
  const auto& wall = *problem_.system.left_wall();
  const auto integrand = [&](double w) {
    const double r = wall.restitution_at_speed(w * cumulants.velocity_deviation);
    const double change = impact_ == ImpactCondition::map
                              ? -2 * (1 - std::pow(r, q)) / (1 + std::pow(r, q))
                              : -q * (1 - r);
    return std::pow(w, q + 1) * change * evaluate_polynomial(polynomial, 0, w) *
           numerics::normal_density(w);
  };
  const double mean = numerics::integrate_by_composite_gauss(integrand, 0, kDeviations, kPanels);
  return 2 * mean * std::pow(s_v, q + 1) * numerics::normal_density(0) / s_y;
}

double MomentEquations::moment_equation_residual(const MatrixXd& moments, int p, int q) const {
  double residual = -q * mean_of_product(coefficients_.force, moments, p, q - 1);
  if (p > 0) residual += p * moments(p - 1, q + 1);
  if (q > 1) residual += q * (q - 1) * mean_of_product(coefficients_.diffusion, moments, p, q - 2);
  for (int j = 1; j <= q; ++j) {
    residual +=
        binomial_coefficient(q, j) *
        mean_of_product(coefficients_.jump_moments[static_cast<std::size_t>(j)], moments, p, q - j);
  }
  return residual;
}

VectorXd MomentEquations::residuals_at(const VectorXd& unknowns) const {
  const Cumulants cumulants = cumulants_of(unknowns);
  const MatrixXd moments = moments_of(cumulants);
  VectorXd residuals(static_cast<Index>(equations_.size()));
  for (Index k = 0; k < residuals.size(); ++k) {
    const auto& [p, q] = equations_[static_cast<std::size_t>(k)];
    residuals[k] = moment_equation_residual(moments, p, q);
    if (has_wall_ && p == 0) residuals[k] += impact_term(cumulants, q);
    // The standard deviation of y^p v^q under a Gaussian density is the scale of an equation.
    residuals[k] /= q * std::sqrt(absolute_normal_moment(2 * p) * absolute_normal_moment(2 * q));
  }
  return residuals;
}

}  // namespace fpkcheck::cumulant
