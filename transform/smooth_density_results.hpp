#pragma once

#include "problem/equation_and_impact_condition.hpp"
#include "problem/problem.hpp"
#include "transform/marginal_density.hpp"
#include "transform/solution.hpp"
#include "transform/solver_metric.hpp"

namespace fpkcheck::transform {

/// Marginal densities of a smooth joint density, and the residuals of its balances.
struct SmoothDensityResults {
  QuadratureMarginals marginals;  ///< moments in the coordinates of the problem's frame
  BalanceResiduals balances;
};

/// Stores a density in a solution, with its mass, its moments in physical coordinates, and the
/// residual of the balance of power.
/// @param impact impact condition of the equation, which defines the power lost in impacts
SmoothDensityResults store_smooth_density(
    const problem::Problem& problem, problem::ImpactCondition impact, const SmoothDensity& density,
    Solution& solution, QuadraturePanelSpacing panels = QuadraturePanelSpacing::uniform);

/// Returns the moments of the physical coordinates y = origin + sign x and y' = sign x' from the
/// marginal densities of x and x'.
Moments physical_moments(const problem::WallFrame& frame, const QuadratureMarginals& marginals);

}  // namespace fpkcheck::transform
