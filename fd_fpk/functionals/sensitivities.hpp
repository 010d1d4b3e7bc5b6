#pragma once

#include <vector>

#include "fd_fpk/options.hpp"
#include "problem/parameter_derivative.hpp"
#include "problem/problem.hpp"
#include "transform/sensitivities.hpp"

namespace fpkcheck::fd_fpk {

/// Computes the derivatives of the stationary moments in transform::kDifferentiatedMoments, and of
/// the stationary marginal densities, with respect to parameters. The derivative dp of the
/// stationary density with respect to a parameter satisfies
///
///     L dp = -dL p,    int dp = 0,
///
/// where dL is the derivative of the generator on the same grid, computed by difference quotients
/// of the generator matrix. The errors follow from three or more grids
/// (FunctionalValuesFromGridSequence). Only the derivatives of moments determine the finest grid.
/// The status is `ok` if the errors of the elasticities of moments, and the L1 errors of theta
/// dp/dtheta for each parameter theta, are at most FiniteVolumeOptions::accuracy.
/// @param parameters derivatives with steps of about 1e-4
/// @param y_edges,ydot_edges increasing edges of the bins of the marginal densities, in physical
///   coordinates; both empty for no derivatives of densities
/// @throws InputError for invalid options
transform::MomentSensitivities solve_sensitivities(
    const problem::Problem& problem, const FiniteVolumeOptions& options,
    const std::vector<problem::ParameterDifferenceQuotient>& parameters,
    const std::vector<double>& y_edges, const std::vector<double>& ydot_edges);

}  // namespace fpkcheck::fd_fpk
