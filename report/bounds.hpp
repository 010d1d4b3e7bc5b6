#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "report/text/format.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// What the guaranteed bounds of a case say, in sentences; none where they were not computed:
///
///   - a solution of the problem itself that is outside by more than it states of its own error,
///     first of all: it is wrong;
///   - the bounds of E[y^2] and E[y'^2], and who is outside any bound: what an approximation does;
///   - or why there are none.
std::vector<std::string> bounds_findings(const results::Case& one);

/// Functional, lower and upper bound, half-width absolute and relative, a line each.
std::string bounds_table(const problem::Problem& problem, const compare::Bounds& bounds,
                         const TextFormat& format);

}  // namespace fpkcheck::report
