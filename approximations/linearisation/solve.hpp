#pragma once

#include <string>

#include "approximations/linearisation/options.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::linearisation {

/// Computes the Gaussian density of statistical linearisation. Impulses enter by their mean and
/// their intensity, like white noise.
///
/// The method ignores that a mass comes to rest. If the moment equations have several solutions,
/// the result is the solution that Newton's method reaches from the motion scales of the problem.
/// @param problem problem in wall coordinates
/// @throws InputError if an option is invalid
/// @pre unsupported_reason() is empty
transform::Solution solve_moment_equations(const problem::Problem& problem,
                                           const LinearisationOptions& options);

/// Returns why the method does not support the problem; empty for a supported problem.
std::string unsupported_reason(const problem::Problem& problem,
                               const LinearisationOptions& options);

}  // namespace fpkcheck::linearisation
