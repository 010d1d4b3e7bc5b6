#pragma once

#include "problem/energy_balance.hpp"
#include "problem/problem.hpp"
#include "transform/panel_marginals.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::epc {

/// Puts a density into a solution, with its mass, its moments and the residual of the balance of
/// power.
/// @param impact by which impacts dissipate power in the equation solved
/// @return the marginals, for comparison with another order's
transform::PanelMarginals put_density(const problem::Problem& problem, problem::Impact impact,
                                      const transform::SmoothDensity& density,
                                      transform::Solution& solution,
                                      transform::Panels panels = transform::Panels::even);

}  // namespace fpkcheck::epc
