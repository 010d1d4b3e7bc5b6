#include "approximations/linearisation/moment_equations.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "numerics/quadrature/gauss_rule.hpp"
#include "numerics/statistics.hpp"
#include "problem/balances.hpp"

namespace fpkcheck::linearisation {
namespace {

// Number of panels of half a standard deviation between -kDomainDeviations and kDomainDeviations,
// and number of Gauss points of a panel
constexpr int kPanelCount = 32;
constexpr unsigned kPoints = 6;

// Returns a quadrature rule for the mean over a normal variable between `low` and `high`. Panels
// end at the kinks, so that the rule is accurate for piecewise smooth functions.
numerics::QuadratureRule normal_rule(double mean, double deviation, double low,
                                     std::vector<double> kinks) {
  const double high = mean + kDomainDeviations * deviation;
  for (int k = 0; k <= kPanelCount; ++k) {
    kinks.push_back(std::lerp(low, high, static_cast<double>(k) / kPanelCount));
  }
  std::ranges::sort(kinks);
  auto rule = numerics::composite_gauss_rule<kPoints>(kinks);
  for (Eigen::Index i = 0; i < rule.size(); ++i) {
    rule.weights[i] *= numerics::normal_density((rule.points[i] - mean) / deviation) / deviation;
  }
  return rule;
}

}  // namespace

MomentEquations::MomentEquations(const problem::Problem& problem, problem::ImpactCondition impact,
                                 const GaussianDensity& initial_density)
    : problem_(problem),
      impact_(impact),
      has_wall_(problem.system.left_wall().has_value()),
      initial_density_(initial_density) {
  assert(!problem.system.right_wall());
}

Eigen::VectorXd MomentEquations::unknowns_of(const GaussianDensity& density) const {
  Eigen::VectorXd unknowns(has_wall_ ? 2 : 3);
  unknowns[0] = std::log(density.displacement_deviation);
  unknowns[1] = std::log(density.velocity_deviation);
  if (!has_wall_) unknowns[2] = density.mean_displacement / initial_density_.displacement_deviation;
  return unknowns;
}

GaussianDensity MomentEquations::density_of(const Eigen::VectorXd& unknowns) const {
  return {
      .mean_displacement = has_wall_ ? 0 : unknowns[2] * initial_density_.displacement_deviation,
      .displacement_deviation = std::exp(unknowns[0]),
      .velocity_deviation = std::exp(unknowns[1])};
}

Eigen::VectorXd MomentEquations::residuals_at(const Eigen::VectorXd& unknowns) const {
  const GaussianDensity density = density_of(unknowns);
  const double mean = density.mean_displacement, s_y = density.displacement_deviation,
               s_v = density.velocity_deviation;
  const double low = has_wall_ ? 0 : mean - kDomainDeviations * s_y;
  const double v_limit = kDomainDeviations * s_v;
  auto rule_y = normal_rule(mean, s_y, low,
                            coefficient_kinks_in_y(problem_, low, mean + kDomainDeviations * s_y));
  if (has_wall_) rule_y.weights *= 2;  // the density of |z|
  const auto rule_v =
      normal_rule(0, s_v, -v_limit, coefficient_kinks_in_v(problem_, -v_limit, v_limit));

  const double mean_impulse_rate = problem_.impulses.rate_times_moment(1);
  const double intensity = problem_.impulses.intensity();
  double drift = 0, virial = 0, power = 0;
  for (Eigen::Index i = 0; i < rule_y.size(); ++i) {
    const double y = rule_y.points[i];
    const double factor = problem_.impulse_factor ? (*problem_.impulse_factor)(y, 0) : 1;
    for (Eigen::Index j = 0; j < rule_v.size(); ++j) {
      const double v = rule_v.points[j], weight = rule_y.weights[i] * rule_v.weights[j];
      const double a = mean_impulse_rate * factor - problem_.system.force(y, v);
      const double diffusion =
          noise_diffusion_coefficient(problem_, y, v) + intensity * factor * factor / 2;
      drift += weight * a;
      virial += weight * (v * v + y * a);
      power += weight * (v * a + diffusion);
    }
  }
  if (has_wall_) {
    const problem::Wall& wall = *problem_.system.left_wall();
    const double wall_density = 2 * numerics::normal_density(0) / s_y;
    power -= wall_density * numerics::integrate_by_composite_gauss(
                                [&](double u) {
                                  return u * energy_loss_at_impact(wall, impact_, u) *
                                         numerics::normal_density(u / s_v) / s_v;
                                },
                                0, v_limit, kPanelCount);
  }

  const double v2 = std::pow(initial_density_.velocity_deviation, 2);
  Eigen::VectorXd residuals(unknowns.size());
  residuals[0] = virial / v2;
  residuals[1] = 2 * power / total_excitation_intensity(problem_);
  if (!has_wall_) residuals[2] = drift * initial_density_.displacement_deviation / v2;
  return residuals;
}

}  // namespace fpkcheck::linearisation
