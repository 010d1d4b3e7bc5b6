#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "report/text/format.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Sentences on the guaranteed bounds of the moments of a case. The list is empty if no bounds were
/// computed.
///
///   - First a sentence for each wrong solution of the full problem: a moment of a wrong solution
///     lies outside the guaranteed bounds by more than the stated error.
///   - Then a sentence with the bounds of E[y^2] and E[y'^2], and with the approximations that have
///     a moment outside its bounds.
///   - If the computation gave no bounds, only a sentence with the reason.
std::vector<std::string> guaranteed_bounds_findings(const results::CaseResult& case_result);

/// A text table with a row for each bounded functional: lower bound, upper bound, absolute and
/// relative half-width.
std::string guaranteed_bounds_table(const problem::Problem& problem,
                                    const compare::GuaranteedBounds& bounds,
                                    const TextFormat& format);

}  // namespace fpkcheck::report
