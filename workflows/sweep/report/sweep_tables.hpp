#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/text/text_layout.hpp"
#include "workflows/sweep/execution/solve_time_forecast.hpp"
#include "workflows/sweep/plan/sweep_plan.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Returns table columns with one row for each method of a sweep: the number of solutions with each
/// status, the L1 distances of `ok` solutions from the references, and the wall-clock time.
std::vector<report::TextTableColumn> method_table_columns(const SweepResults& results);

const char* method_table_legend();

/// Returns the terminal text of a sweep: the varied keys and a table with one row for each method.
std::string sweep_table_text(const SweepResults& results, const report::TerminalTextFormat& format);

/// Returns the text of a duration, e.g. "40 s", "12 min", "3.5 h".
std::string duration_text(double seconds);

/// Returns the expected wall-clock times of a plan as text, the output of --dry-run.
/// @param threads number of threads on this machine
/// @param ranks numbers of single-threaded processes, one for each row of the table
std::string solve_time_forecast_text(const SweepPlan& plan, const SolveTimeForecast& forecast,
                                     std::size_t threads, const std::vector<int>& ranks,
                                     const report::TerminalTextFormat& format);

}  // namespace fpkcheck::sweep
