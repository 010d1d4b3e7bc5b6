#include "transform/smooth_density_results.hpp"

#include <cmath>
#include <functional>

#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/balances.hpp"

namespace fpkcheck::transform {
namespace {

// Returns the moment int_{v>0} v^power p(b, v) dv of the density p at the right wall y = b, or 0
// without a right wall.
double right_wall_flux_moment(const problem::Problem& problem, const SmoothDensity& density,
                              int power) {
  if (!problem.system.right_wall()) return 0;
  constexpr int kPanels = 8;
  const double b = problem.system.right_wall()->position;
  const auto integrand = [&](double v) { return std::pow(v, power) * density.value(b, v); };
  return numerics::integrate_by_composite_gauss(integrand, 0.0, density.v_max, kPanels);
}

// Returns int_{u>0} u weight(u) p(a, towards u) du at a wall y = a: the sum of `weight` as a
// function of the impact speed u over the impacts per unit time.
double impact_sum_per_time(const SmoothDensity& density, double position, double towards,
                           const std::function<double(double)>& weight) {
  constexpr int kPanels = 8;
  const auto integrand = [&](double u) {
    return u * weight(u) * density.value(position, towards * u);
  };
  return numerics::integrate_by_composite_gauss(integrand, 0.0, density.v_max, kPanels);
}

// Energy that impacts on each wall dissipate per unit time, and momentum that each wall transfers
// to the moving mass per unit time.
struct WallEnergyAndMomentumTransfer {
  double left_loss, right_loss, left_momentum, right_momentum;
};

WallEnergyAndMomentumTransfer balance_terms_of_walls(const problem::Problem& problem,
                                                     problem::ImpactCondition impact,
                                                     const SmoothDensity& density) {
  const problem::System& system = problem.system;
  const auto &left = system.left_wall(), &right = system.right_wall();
  if (system.has_constant_restitution()) {
    return {.left_loss =
                problem::impact_energy_loss_rate(left, impact, flux_into_left_wall(density, 3)),
            .right_loss = problem::impact_energy_loss_rate(
                right, impact, right_wall_flux_moment(problem, density, 3)),
            .left_momentum = problem::impact_momentum_rate(left, flux_into_left_wall(density, 2)),
            .right_momentum =
                problem::impact_momentum_rate(right, right_wall_flux_moment(problem, density, 2))};
  }
  const auto sum = [&](const std::optional<problem::Wall>& wall, double towards,
                       const auto& quantity) {
    if (!wall) return 0.0;
    return impact_sum_per_time(density, wall->position, towards,
                               [&](double u) { return quantity(*wall, u); });
  };
  const auto loss = [impact](const problem::Wall& wall, double u) {
    return problem::energy_loss_at_impact(wall, impact, u);
  };
  return {.left_loss = sum(left, -1, loss),
          .right_loss = sum(right, 1, loss),
          .left_momentum = sum(left, -1, problem::momentum_change_at_impact),
          .right_momentum = sum(right, 1, problem::momentum_change_at_impact)};
}

double mean_damping_power(const problem::System& system, const SmoothDensity& density) {
  if (!system.has_polynomial_force()) {
    return expectation(density, [&](double y, double v) { return v * system.damping_force(y, v); });
  }
  return expectation(density, [&](double y, double v) {
    return (system.damping_polynomial()(y) + system.rayleigh_coefficient() * v * v) * v * v;
  });
}

problem::PowerBalanceTerms power_balance_terms(const problem::Problem& problem,
                                               const WallEnergyAndMomentumTransfer& walls,
                                               const SmoothDensity& density,
                                               const Moments& moments) {
  const problem::System& system = problem.system;
  problem::PowerBalanceTerms terms{.mean_velocity = moments.v1,
                                   .mean_square_velocity = moments.v2,
                                   .left_impact_loss = walls.left_loss,
                                   .right_impact_loss = walls.right_loss};
  if (!system.has_constant_damping()) {
    terms.mean_damping_power = mean_damping_power(system, density);
  }
  if (problem.noise_factor) {
    terms.mean_square_noise_factor = expectation(density, [&](double y, double v) {
      return problem.noise_factor->squared_noise_factor(y, v);
    });
  }
  return terms;
}

BalanceResiduals balance_residuals(const problem::Problem& problem,
                                   const WallEnergyAndMomentumTransfer& walls,
                                   const SmoothDensity& density,
                                   const QuadratureMarginals& marginals) {
  const problem::System& system = problem.system;
  problem::VirialBalanceTerms virial{.mean_displacement = marginals.moments.y1,
                                     .mean_square_velocity = marginals.moments.v2,
                                     .mean_virial = 0,
                                     .right_impact_momentum = walls.right_momentum};
  problem::MomentumBalanceTerms momentum{.mean_force = 0,
                                         .left_impact_momentum = walls.left_momentum,
                                         .right_impact_momentum = walls.right_momentum};
  const auto mean = [&](const auto& g) { return expectation(density, g); };
  if (system.has_polynomial_force()) {
    const auto& force = system.restoring_force();
    virial.mean_virial = mean_of_displacement_polynomial(marginals, force.multiplied_by_argument());
    momentum.mean_force = mean_of_displacement_polynomial(marginals, force);
    if (system.rayleigh_coefficient() != 0) {
      virial.mean_y_cubed_velocity = mean([](double y, double v) { return y * v * v * v; });
      momentum.mean_cubed_velocity = mean([](double, double v) { return v * v * v; });
    }
  } else {
    virial.mean_virial = mean([&](double y, double v) { return y * system.force(y, v); });
    momentum.mean_force = mean([&](double y, double v) { return system.force(y, v); });
  }
  BalanceResiduals residuals{
      .virial = problem::virial_balance(problem, virial).relative_balance_residual()};
  // Smallest scale of the momentum balance. Without impacts both sides of the momentum balance may
  // be 0, and the relative residual would be a rounding error.
  constexpr double kRounding = 1e-9;
  const double force_unit = marginals.moments.v2 / std::sqrt(marginals.moments.y2);
  const problem::BalanceEquation balance = problem::momentum_balance(problem, momentum);
  if (balance.scale > kRounding * force_unit)
    residuals.momentum = balance.relative_balance_residual();
  return residuals;
}

}  // namespace

Moments physical_moments(const problem::WallFrame& frame, const QuadratureMarginals& marginals) {
  Moments moments = marginals.moments;
  if (frame.is_identity()) return moments;
  const auto mean_of_power = [&](std::size_t n) {
    numerics::Polynomial::Coefficients power{};
    power[n] = 1;
    return mean_of_displacement_polynomial(
        marginals, numerics::Polynomial(power).compose_affine(frame.origin, frame.velocity_sign()));
  };
  moments.y1 = mean_of_power(1);
  moments.y2 = mean_of_power(2);
  moments.y4 = mean_of_power(4);
  moments.v1 = frame.physical_velocity(moments.v1);
  return moments;
}

SmoothDensityResults store_smooth_density(const problem::Problem& problem,
                                          problem::ImpactCondition impact,
                                          const SmoothDensity& density, Solution& solution,
                                          QuadraturePanelSpacing panels) {
  SmoothDensityResults results{
      .marginals = marginals_at_quadrature_points(density, density.y_max, density.v_max, panels),
      .balances = {}};
  solution.density = density;
  solution.mass = results.marginals.mass;
  solution.moments = physical_moments(problem.frame, results.marginals);
  const WallEnergyAndMomentumTransfer walls = balance_terms_of_walls(problem, impact, density);
  solution.energy_residual = problem::power_balance_residual(
      problem, power_balance_terms(problem, walls, density, results.marginals.moments));
  results.balances = balance_residuals(problem, walls, density, results.marginals);
  return results;
}

}  // namespace fpkcheck::transform
