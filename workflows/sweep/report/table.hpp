#pragma once

#include <string>

#include "report/text/format.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// The results of a sweep as text for the terminal: the varied keys, and a table with a row for
/// each method (method_columns.hpp).
std::string table(const SweepResults& results, const report::TextFormat& format);

}  // namespace fpkcheck::sweep
