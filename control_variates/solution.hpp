#pragma once

#include <string>

#include "control_variates/result.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::control_variates {

/// What a simulation with control functions tells, as a solution: the plain one's, with the
/// controlled moments in place of its own, smooth estimates, and the checks as observations.
transform::Solution solution_of(Result&& result);

/// The plain solution, with a note that there are no control functions.
/// @param why a clause
transform::Solution without_control(transform::Solution&& plain, const std::string& why);

}  // namespace fpkcheck::control_variates
