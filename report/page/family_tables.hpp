#pragma once

#include <string>

#include "results/run.hpp"

namespace fpkcheck::report {

/// Tables of the metrics of the solvers. The table of a family has a column for each solution and a
/// row for each metric; grouped metrics ("support.edge_density") are below all other metrics. The
/// tables omit lists (coefficients, quantiles), metrics without a value in the family, and metrics
/// that repeat an option.
std::string family_tables(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
