#pragma once

#include <functional>
#include <string>

#include "methods/method.hpp"

namespace fpkcheck::methods {

/// Solves a problem in its frame (problem/frame.hpp), with the wall at 0, and returns the solution on
/// the physical axes; or one that is `not_offered`.
/// @param objection why the solver does not treat the problem; empty where it does
transform::Solution solve_in_frame(
    const problem::Problem& problem, const Setting& setting,
    const std::function<std::string(const problem::Problem&)>& objection,
    const std::function<transform::Solution(const problem::Problem&, const Setting&)>& solve);

}  // namespace fpkcheck::methods
