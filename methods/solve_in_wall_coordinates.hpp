#pragma once

#include <functional>
#include <string>

#include "methods/method.hpp"

namespace fpkcheck::methods {

/// Solves a problem in wall coordinates (problem/frame.hpp), in which the wall is at 0, and returns
/// the solution in physical coordinates. If the solver does not support the problem, the status of
/// the solution is `not_offered`, and its reason is the result of `unsupported_reason`.
/// @param unsupported_reason function of the transformed problem that returns the reason why the
///        solver does not support the problem; an empty reason if the solver supports the problem
/// @param solve function that solves the transformed problem on the transformed axes
transform::Solution solve_in_wall_coordinates(
    const problem::Problem& problem, const SolveContext& context,
    const std::function<std::string(const problem::Problem&)>& unsupported_reason,
    const std::function<transform::Solution(const problem::Problem&, const SolveContext&)>& solve);

}  // namespace fpkcheck::methods
