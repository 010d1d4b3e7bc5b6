#include "epc/form/put_density.hpp"

#include "problem/motion_balances.hpp"

namespace fpkcheck::epc {
namespace {

transform::BalanceResiduals balance_residuals(const problem::Problem& problem,
                                              const transform::SmoothDensity& density,
                                              const transform::PanelMarginals& marginals) {
  const auto& force = problem.system.force();
  const auto virial =
      problem::virial_balance(problem, {.mean_displacement = marginals.moments.y1,
                                        .mean_square_velocity = marginals.moments.v2,
                                        .mean_virial = mean_of(marginals, force.times_argument())});
  const auto momentum =
      problem::momentum_balance(problem, {.mean_force = mean_of(marginals, force),
                                          .impact_momentum = transform::impact_flux(density, 2)});
  return {.virial = virial.residual(), .momentum = momentum.residual()};
}

}  // namespace

transform::PanelMarginals put_density(const problem::Problem& problem, problem::Impact impact,
                                      const transform::SmoothDensity& density, Result& result,
                                      transform::Panels panels) {
  transform::PanelMarginals marginals =
      transform::panel_marginals(density, density.y_max, density.v_max, panels);
  auto& solution = result.solution;
  solution.density = density;
  solution.mass = marginals.mass;
  solution.moments = marginals.moments;
  solution.energy_residual =
      problem::energy_residual(problem, impact,
                               {.mean_velocity = marginals.moments.v1,
                                .mean_square_velocity = marginals.moments.v2,
                                .impact_energy_flux = transform::impact_flux(density, 3)});
  result.summary.balances = balance_residuals(problem, density, marginals);
  return marginals;
}

}  // namespace fpkcheck::epc
