#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/text/columns.hpp"
#include "compare/text/format.hpp"

namespace fpkcheck::compare {

/// The budgets of a case as rows of text: per closure and variable the L1 distance to the reference
/// and its parts, then what all chains end with (discretisation, sampling) in rows of their own; an
/// asterisk where a closure is not ok. Under them the sentence "limits". Empty without a budget.
/// @param summary_case one element of "cases" in summary.json
/// @param format where the rows do not fit, the tail goes, then the parts, those
///              at the end of the chain first
std::string budget_table(const nlohmann::ordered_json& summary_case, const TextFormat& format);

/// The columns of its rows that are shown; none without a budget.
std::vector<Column> budget_columns(const nlohmann::ordered_json& summary_case,
                                   const TextFormat& format);

}  // namespace fpkcheck::compare
