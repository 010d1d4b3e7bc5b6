#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/text/format.hpp"
#include "workflows/sweep/execution/forecast.hpp"
#include "workflows/sweep/plan/plan.hpp"

namespace fpkcheck::sweep {

/// The text of a duration: "40 s", "12 min", "3.5 h".
std::string duration_text(double seconds);

/// The text that --dry-run prints: the expected wall-clock times of a plan.
/// @param threads number of threads on this machine
/// @param ranks numbers of single-threaded processes for the rows of the table
std::string forecast_text(const Plan& plan, const Forecast& forecast, std::size_t threads,
                          const std::vector<int>& ranks, const report::TextFormat& format);

}  // namespace fpkcheck::sweep
