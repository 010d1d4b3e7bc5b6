#pragma once

#include <vector>

#include "report/text/columns.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// A row for each method: counts of the statuses, distances of its `ok` solutions to the
/// references, and its wall-clock time.
std::vector<report::Column> method_columns(const SweepResults& results);

/// Explanation of the headers.
const char* method_columns_legend();

}  // namespace fpkcheck::sweep
