#pragma once

#include <vector>

#include "report/text/columns.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// The columns of a table with a row for each method. The row has the numbers of solutions of each
/// status, the distances of the `ok` solutions to the references, and the wall-clock time.
std::vector<report::TextColumn> method_columns(const SweepResults& results);

/// The sentences that explain the headers of method_columns.
const char* method_columns_legend();

}  // namespace fpkcheck::sweep
