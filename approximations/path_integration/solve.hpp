#pragma once

#include <string>

#include "approximations/path_integration/options.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::path_integration {

/// Computes the stationary density by path integration. The density of a grid is the extrapolation
/// to the time step 0 from two time steps. The error estimate is the Richardson estimate from three
/// grids, whose spline intervals and time steps decrease by the factor sqrt(2).
///
/// The status is `inaccurate` if the error estimate exceeds the accuracy of the options, and
/// `not_converged` if the iteration for the stationary density does not converge.
/// @param problem problem in wall coordinates
/// @throws InputError if an option is invalid
transform::Solution solve_by_path_integration(const problem::Problem& problem,
                                              const PathIntegrationOptions& options);

/// Returns why the method does not support the problem; empty for a supported problem.
std::string unsupported_reason(const problem::Problem& problem,
                               const PathIntegrationOptions& options);

}  // namespace fpkcheck::path_integration
