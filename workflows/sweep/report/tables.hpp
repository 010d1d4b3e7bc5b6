#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/text/columns.hpp"
#include "report/text/format.hpp"
#include "workflows/sweep/execution/forecast.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// The columns of a table with a row for each method. The row has the numbers of solutions of each
/// status, the distances of the `ok` solutions to the references, and the wall-clock time.
std::vector<report::TextColumn> method_columns(const SweepResults& results);

/// The sentences that explain the headers of method_columns.
const char* method_columns_legend();

/// The results of a sweep as text for the terminal: the varied keys, and a table with a row for
/// each method (method_columns).
std::string table(const SweepResults& results, const report::TextFormat& format);

/// The text of a duration: "40 s", "12 min", "3.5 h".
std::string duration_text(double seconds);

/// The text that --dry-run prints: the expected wall-clock times of a plan.
/// @param threads number of threads on this machine
/// @param ranks numbers of single-threaded processes for the rows of the table
std::string forecast_text(const Plan& plan, const Forecast& forecast, std::size_t threads,
                          const std::vector<int>& ranks, const report::TextFormat& format);

}  // namespace fpkcheck::sweep
