#pragma once

#include <set>
#include <string>

#include "results/run.hpp"

namespace fpkcheck::report {

/// Ids of the solutions that are initially visible in a plot: the solutions of the full problem
/// (report/references.hpp), the closest closure of each family and external densities; all
/// solutions if these are fewer than two.
std::set<std::string> initially_visible(const results::Case& case_result);

}  // namespace fpkcheck::report
