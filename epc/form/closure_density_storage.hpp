#pragma once

#include "epc/summary.hpp"
#include "problem/balances.hpp"
#include "problem/problem.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::epc {

/// Stores a closure density in a result, with its integral, its moments and the residuals of the
/// balances of power, virial and momentum. The solution stores the moments in physical coordinates,
/// the summary in the coordinates of the problem.
/// @param impact impact condition, which defines the power lost in impacts
/// @return marginal densities
transform::QuadratureMarginals store_density(
    const problem::Problem& problem, problem::ImpactCondition impact,
    const transform::SmoothDensity& density, ClosureResult& result,
    transform::QuadraturePanelSpacing panels = transform::QuadraturePanelSpacing::uniform);

/// Returns the moments of the physical coordinates y = origin + sign x and y' = sign x' from the
/// marginal densities of x and x'.
transform::Moments physical_moments(const problem::WallFrame& frame,
                                    const transform::QuadratureMarginals& marginals);

}  // namespace fpkcheck::epc
