#include "epc/form/store_density.hpp"

#include <cmath>

#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/balances.hpp"

namespace fpkcheck::epc {
namespace {

// Returns int_{v>0} v^power p(b, v) dv at the right wall y = b, or 0 without a right wall.
double right_flux(const problem::Problem& problem, const transform::SmoothDensity& density,
                  int power) {
  if (!problem.system.right_wall()) return 0;
  constexpr int kPanels = 8;
  const double b = problem.system.right_wall()->position;
  const auto integrand = [&](double v) { return std::pow(v, power) * density.value(b, v); };
  return numerics::integrate_by_composite_gauss(integrand, 0.0, density.v_max, kPanels);
}

double damping_power(const problem::System& system, const transform::SmoothDensity& density) {
  return transform::expectation(density, [&](double y, double v) {
    return (system.damping_polynomial()(y) + system.rayleigh_coefficient() * v * v) * v * v;
  });
}

problem::PowerBalanceTerms energy_terms(const problem::Problem& problem,
                                        problem::ImpactCondition impact,
                                        const transform::SmoothDensity& density,
                                        const transform::Moments& moments) {
  const problem::System& system = problem.system;
  problem::PowerBalanceTerms terms{
      .mean_velocity = moments.v1,
      .mean_square_velocity = moments.v2,
      .left_impact_loss =
          problem::impact_loss(system.left_wall(), impact, transform::impact_flux(density, 3)),
      .right_impact_loss =
          problem::impact_loss(system.right_wall(), impact, right_flux(problem, density, 3))};
  if (!system.has_constant_damping()) {
    terms.mean_damping_power = damping_power(system, density);
  }
  return terms;
}

transform::BalanceResiduals balance_residuals(const problem::Problem& problem,
                                              const transform::SmoothDensity& density,
                                              const transform::QuadratureMarginals& marginals) {
  const auto& force = problem.system.restoring_force();
  const problem::System& system = problem.system;
  const double right_momentum =
      problem::impact_momentum_change(system.right_wall(), right_flux(problem, density, 2));
  problem::VirialBalanceTerms virial{
      .mean_displacement = marginals.moments.y1,
      .mean_square_velocity = marginals.moments.v2,
      .mean_virial = mean_of_displacement_polynomial(marginals, force.multiplied_by_argument()),
      .right_impact_momentum = right_momentum};
  problem::MomentumBalanceTerms momentum{
      .mean_force = mean_of_displacement_polynomial(marginals, force),
      .left_impact_momentum =
          problem::impact_momentum_change(system.left_wall(), transform::impact_flux(density, 2)),
      .right_impact_momentum = right_momentum};
  if (problem.system.rayleigh_coefficient() != 0) {
    const auto mean = [&](const auto& g) { return transform::expectation(density, g); };
    virial.mean_y_cubed_velocity = mean([](double y, double v) { return y * v * v * v; });
    momentum.mean_cubed_velocity = mean([](double, double v) { return v * v * v; });
  }
  transform::BalanceResiduals residuals{.virial =
                                            problem::virial_balance(problem, virial).residual()};
  // Threshold of the momentum balance: without impacts the left and the right side may be 0, and
  // the residual would be a rounding error.
  constexpr double kRounding = 1e-9;
  const double force_unit = marginals.moments.v2 / std::sqrt(marginals.moments.y2);
  const problem::BalanceEquation balance = problem::momentum_balance(problem, momentum);
  if (balance.scale > kRounding * force_unit) residuals.momentum = balance.residual();
  return residuals;
}

// Returns the moments of the physical coordinates y = origin + sign x and y' = sign x'.
transform::Moments physical_moments(const problem::WallFrame& frame,
                                    const transform::QuadratureMarginals& marginals) {
  transform::Moments moments = marginals.moments;
  if (frame.is_identity()) return moments;
  const auto mean_of_power = [&](std::size_t n) {
    numerics::Polynomial::Coefficients power{};
    power[n] = 1;
    return mean_of_displacement_polynomial(
        marginals, numerics::Polynomial(power).compose_affine(frame.origin, frame.sign()));
  };
  moments.y1 = mean_of_power(1);
  moments.y2 = mean_of_power(2);
  moments.y4 = mean_of_power(4);
  moments.v1 = frame.physical_velocity(moments.v1);
  return moments;
}

}  // namespace

transform::QuadratureMarginals store_density(const problem::Problem& problem,
                                             problem::ImpactCondition impact,
                                             const transform::SmoothDensity& density,
                                             Result& result,
                                             transform::QuadraturePanelSpacing panels) {
  transform::QuadratureMarginals marginals =
      transform::quadrature_marginals(density, density.y_max, density.v_max, panels);
  auto& solution = result.solution;
  solution.density = density;
  solution.mass = marginals.mass;
  solution.moments = physical_moments(problem.frame, marginals);
  solution.energy_residual =
      problem::energy_residual(problem, energy_terms(problem, impact, density, marginals.moments));
  result.summary.moments = marginals.moments;
  result.summary.balances = balance_residuals(problem, density, marginals);
  return marginals;
}

}  // namespace fpkcheck::epc
