#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/page/plot.hpp"

/// "budget" of a case in summary.json: what each approximation adds to a solution's distance from
/// the simulation.
namespace fpkcheck::compare {

/// Bars: a plot for each variable. None without a budget.
std::vector<Plot> budget_plots(const nlohmann::ordered_json& summary_case,
                               const std::string& prefix);

/// The same numbers and those of the tails as tables.
std::string budget_tables(const nlohmann::ordered_json& summary_case);

}  // namespace fpkcheck::compare
