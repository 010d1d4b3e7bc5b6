#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "report/text/text_format.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Returns sentences on the guaranteed bounds of the moments of a case. If the computation of
/// bounds was omitted, the list is empty.
///
/// - First, one sentence states each wrong solution of the full problem. A wrong solution has a
/// moment that is outside the guaranteed bounds by more than its error estimate.
/// - Then one sentence states the bounds of E[y^2] and E[y'^2], and the approximations with a
///   moment outside its bounds.
/// - If the computation gave no bounds, the only sentence states the reason.
std::vector<std::string> guaranteed_bounds_findings(const results::CaseResult& case_result);

/// Returns a text table of the guaranteed bounds. Each row has the lower bound, upper bound, and
/// absolute and relative half-width for one functional.
std::string guaranteed_bounds_table(const problem::Problem& problem,
                                    const compare::GuaranteedBounds& bounds,
                                    const TextFormat& format);

}  // namespace fpkcheck::report
