#pragma once

#include <string>

#include "approximations/cumulant/options.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::cumulant {

/// Solves the moment equations of the orders 2, 4, .. n, closed by cumulant neglect. Each search by
/// Newton's method, or else by arclength continuation, starts from the solution of the preceding
/// order. The density is the Gram-Charlier series of the cumulants.
///
/// The status is `inadmissible` if the density is negative; the moments are those of the equations.
/// The status is `not_converged` if no solution of the equations was found. The method ignores that
/// a mass comes to rest. If the equations have several solutions, the result is the solution that
/// is reached from the Gaussian one.
/// @param problem problem in wall coordinates
/// @throws InputError if an option is invalid
/// @pre unsupported_reason() is empty
transform::Solution solve_moment_equations(const problem::Problem& problem,
                                           const CumulantOptions& options);

/// Returns why the method does not support the problem; empty for a supported problem.
std::string unsupported_reason(const problem::Problem& problem, const CumulantOptions& options);

}  // namespace fpkcheck::cumulant
