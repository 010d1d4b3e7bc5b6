#pragma once

#include <vector>

#include "fd_fpk/options.hpp"
#include "problem/parameter_derivative.hpp"
#include "problem/problem.hpp"
#include "transform/sensitivities.hpp"

namespace fpkcheck::fd_fpk {

/// Computes the derivatives of the stationary moments (transform::kMoments) with respect to
/// parameters. The derivative dp of the stationary density with respect to a parameter satisfies
///
///     L dp = -dL p,    int dp = 0,
///
/// where dL is the derivative of the generator on the same grid, computed by difference quotients
/// of the generator matrix. The errors follow from three or more grids (ConvergedValues).
/// @param parameters derivatives with steps of about 1e-4
/// @throws InputError for invalid options
transform::Sensitivities solve_sensitivities(
    const problem::Problem& problem, const Options& options,
    const std::vector<problem::ParameterDerivative>& parameters);

}  // namespace fpkcheck::fd_fpk
