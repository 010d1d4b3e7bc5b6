#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "report/text/format.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Findings on the guaranteed bounds of a case, in sentences. Empty if no bounds were computed.
///
///   - First each solution of the full problem whose moment lies outside its bounds by more than
///     the stated error: this solution is wrong.
///   - Then the bounds of E[y^2] and E[y'^2], and the approximations with a moment outside a bound.
///   - Without bounds, the reason.
std::vector<std::string> bounds_findings(const results::Case& case_result);

/// A table with a row for each functional: lower and upper bound, absolute and relative half-width.
std::string bounds_table(const problem::Problem& problem, const compare::Bounds& bounds,
                         const TextFormat& format);

}  // namespace fpkcheck::report
