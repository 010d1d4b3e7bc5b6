#include "epc/form/put_density.hpp"

namespace fpkcheck::epc {

transform::PanelMarginals put_density(const problem::Problem& problem, problem::Impact impact,
                                      const transform::SmoothDensity& density,
                                      transform::Solution& solution, transform::Panels panels) {
  transform::PanelMarginals marginals =
      transform::panel_marginals(density, density.y_max, density.v_max, panels);
  solution.density = density;
  solution.mass = marginals.mass;
  solution.moments = marginals.moments;
  solution.energy_residual =
      problem::energy_residual(problem, impact,
                               {.mean_velocity = marginals.moments.v1,
                                .mean_square_velocity = marginals.moments.v2,
                                .impact_energy_flux = transform::impact_flux(density, 3)});
  return marginals;
}

}  // namespace fpkcheck::epc
