#pragma once

#include <vector>

#include "report/text/columns.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// A row for each method: how often it ended how, how far its `ok` answers are from the references,
/// and how long it took.
std::vector<report::Column> method_columns(const SweepResults& results);

/// What their headers mean.
const char* method_columns_legend();

}  // namespace fpkcheck::sweep
