#pragma once

#include <string>

#include "control_variates/result.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::control_variates {

/// The solution of a simulation with control variates. The plain solution receives the controlled
/// moments, the estimates in smooth bins, and the checks as metrics.
transform::Solution make_solution(Result&& result);

/// The plain solution with a note that no control variates are used.
/// @param reason reason in one clause, completes the note
transform::Solution make_plain_solution(transform::Solution&& plain, const std::string& reason);

}  // namespace fpkcheck::control_variates
