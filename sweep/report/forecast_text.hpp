#pragma once

#include <cstddef>
#include <string>

#include "sweep/execution/forecast.hpp"
#include "sweep/plan/plan.hpp"

namespace fpkcheck::sweep {

/// "40 s", "12 min", "3.5 h"
std::string time_text(double seconds);

/// What --dry-run says.
/// @param threads of this machine
/// @param ranks for which it is told too
std::string forecast_text(const Plan& plan, const Forecast& forecast, std::size_t threads,
                          std::size_t ranks, std::size_t width);

}  // namespace fpkcheck::sweep
