#pragma once

#include <set>
#include <string>

#include "results/run.hpp"

namespace fpkcheck::report {

/// The ids of the solutions that are initially visible in a plot: the solutions of the full problem
/// (report/references.hpp), the closest closure of each family, and external densities. If this
/// selection has fewer than two solutions, all solutions are visible.
std::set<std::string> initially_visible_solutions(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
