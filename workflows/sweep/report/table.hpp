#pragma once

#include <string>

#include "report/text/format.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// For the terminal: what was varied, and a line for each method: how often it ended how, how far its
/// `ok` answers are from the references, and how long it took.
std::string table(const SweepResults& results, const report::TextFormat& format);

}  // namespace fpkcheck::sweep
