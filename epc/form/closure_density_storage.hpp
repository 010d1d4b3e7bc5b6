#pragma once

#include "epc/summary.hpp"
#include "problem/balances.hpp"
#include "problem/problem.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::epc {

/// Stores a density in a result, with its mass, its moments and the residuals of the balances of
/// power, virial and momentum. The moments are in physical coordinates in the solution, and in the
/// coordinates of the problem's frame in the summary.
/// @param impact impact condition of the equation, which defines the power lost in impacts
/// @return marginal densities
transform::QuadratureMarginals store_density(
    const problem::Problem& problem, problem::ImpactCondition impact,
    const transform::SmoothDensity& density, ClosureResult& result,
    transform::QuadraturePanelSpacing panels = transform::QuadraturePanelSpacing::uniform);

/// Returns the moments of the physical coordinates y = origin + sign x and y' = sign x' from the
/// marginals of x and x'.
transform::Moments physical_moments(const problem::WallFrame& frame,
                                    const transform::QuadratureMarginals& marginals);

}  // namespace fpkcheck::epc
