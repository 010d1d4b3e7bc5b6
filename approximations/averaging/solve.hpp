#pragma once

#include <string>

#include "approximations/averaging/options.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::averaging {

/// Computes the density of stochastic averaging, a function of the energy and of the well. The
/// density becomes exact as damping, impacts and excitation become weak in proportion.
///
/// The status is `inadmissible` if the averaged equation has a negative density.
/// @param problem problem in wall coordinates
/// @throws InputError if an option is invalid
transform::Solution solve_averaged_equation(const problem::Problem& problem,
                                            const AveragingOptions& options);

/// Returns why the method does not support the problem; empty for a supported problem.
std::string unsupported_reason(const problem::Problem& problem, const AveragingOptions& options);

}  // namespace fpkcheck::averaging
