#pragma once

#include <functional>
#include <string>

#include "methods/method.hpp"

namespace fpkcheck::methods {

/// Solves a problem in wall coordinates (problem/frame.hpp), with the wall at 0, and returns the
/// solution on the physical axes. Where the solver does not support the problem, the status is
/// `not_offered` and the reason is that of `unsupported_reason`.
/// @param unsupported_reason why the solver does not support the transformed problem, or empty
/// @param solve solves the transformed problem on the transformed axes
transform::Solution solve_in_wall_coordinates(
    const problem::Problem& problem, const SolveContext& context,
    const std::function<std::string(const problem::Problem&)>& unsupported_reason,
    const std::function<transform::Solution(const problem::Problem&, const SolveContext&)>& solve);

}  // namespace fpkcheck::methods
