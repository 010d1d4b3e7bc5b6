#pragma once

#include <string>

#include "report/text/format.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Text for the terminal: the varied keys, and a row for each method: counts of the statuses,
/// distances of its `ok` solutions to the references, and its wall-clock time.
std::string table(const SweepResults& results, const report::TextFormat& format);

}  // namespace fpkcheck::sweep
