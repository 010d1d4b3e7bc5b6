#pragma once

#include <string>

#include "results/run.hpp"

namespace fpkcheck::report {

/// Tables of the metrics of the solvers: for each family a table with a column for each solution
/// and a row for each metric, with groups ("support.edge_density") below the others. Omitted are
/// lists (coefficients, quantiles), metrics without a value in the family, and metrics that repeat
/// an option.
std::string family_tables(const results::Case& case_result);

}  // namespace fpkcheck::report
