#pragma once

#include <string>

#include "results/run.hpp"

namespace fpkcheck::report {

/// Returns tables of the metrics of the solvers. The table of a family of methods has a column for
/// each solution and a row for each metric. Grouped metrics ("support.edge_density") come last. The
/// tables omit lists (coefficients, quantiles), metrics without a value in the family, and metrics
/// that repeat an option.
std::string metric_tables_html(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
