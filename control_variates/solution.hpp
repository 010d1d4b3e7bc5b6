#pragma once

#include <string>

#include "control_variates/result.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::control_variates {

/// The solution of a simulation with control variates: the plain solution with the controlled
/// moments, the smooth estimates, and the checks as metrics.
transform::Solution make_solution(Result&& result);

/// The plain solution with a note that it has no control variates.
/// @param why one clause
transform::Solution make_plain_solution(transform::Solution&& plain, const std::string& why);

}  // namespace fpkcheck::control_variates
