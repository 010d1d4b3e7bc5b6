#pragma once

#include <string>
#include <vector>

#include "compare/budget.hpp"
#include "report/text/columns.hpp"
#include "report/text/format.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The budgets of a case as rows of text: per closure and variable the L1 distance to the reference
/// and its parts, then what all chains end with (discretisation, sampling) in rows of their own; an
/// asterisk where a closure is not ok. Under them the sentence of the limits. Empty without a
/// budget.
/// @param format where the rows do not fit, the tail goes, then the parts, those at the end of the
///               chain first
std::string budget_table(const results::Case& one, const TextFormat& format);

/// The columns of its rows that are shown; none without a budget.
std::vector<Column> budget_columns(const results::Case& one, const TextFormat& format);

/// A part's name as a header, which has little room: "trunc.".
std::string part_header(const std::string& part);

}  // namespace fpkcheck::report
