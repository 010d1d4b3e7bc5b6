#pragma once

#include "epc/panel_marginals.hpp"
#include "problem/energy_balance.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::epc {

/// Puts a density into a solution, with its mass, its moments and the residual of the balance of
/// power.
/// @param impact by which impacts dissipate power in the equation solved
/// @return the marginals, for comparison with another order's
PanelMarginals put_density(const problem::Problem& problem, problem::Impact impact,
                           const transform::SmoothDensity& density, transform::Solution& solution,
                           Panels panels = Panels::even);

}  // namespace fpkcheck::epc
