#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace fpkcheck::compare {

/// True when a case has a budget that can be drawn.
bool has_budget(const nlohmann::ordered_json& summary_case);

/// A gnuplot script that draws a case's error budget: per variable, in L1 and in the tail, a group
/// of bars for each closure, one bar a part, on a logarithmic axis; a black line across the group
/// is the total, paler bars are those of closures that are not ok.
/// @param summary_case one element of "cases" in summary.json
std::string budget_script(const nlohmann::ordered_json& summary_case, const std::string& file_stem);

}  // namespace fpkcheck::compare
