#pragma once

#include "epc/summary.hpp"
#include "problem/energy_balance.hpp"
#include "problem/problem.hpp"
#include "transform/panel_marginals.hpp"

namespace fpkcheck::epc {

/// Puts a density into a result, with its mass, its moments (the physical ones into the solution,
/// those of the problem's frame into the summary) and the residuals of the balances of power,
/// virial and momentum.
/// @param impact by which impacts dissipate power in the equation solved
/// @return the marginals, for comparison with another order's
transform::PanelMarginals put_density(const problem::Problem& problem, problem::Impact impact,
                                      const transform::SmoothDensity& density, Result& result,
                                      transform::Panels panels = transform::Panels::even);

}  // namespace fpkcheck::epc
