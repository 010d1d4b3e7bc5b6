#pragma once

#include <string>

#include "results/run.hpp"

namespace fpkcheck::report {

/// What the solvers alone know of their solutions: for each family a table with a column for each
/// solution and a row for each observation, groups ("support.edge_density") below the others. Left
/// out are lists (coefficients, quantiles), what no solution of the family has, and what only
/// repeats the options that were asked for.
std::string family_tables(const results::Case& one);

}  // namespace fpkcheck::report
