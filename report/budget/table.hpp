#pragma once

#include <string>
#include <vector>

#include "compare/budget.hpp"
#include "report/text/columns.hpp"
#include "report/text/format.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The error budget of a case as a text table: for each closure and marginal the L1 distance to the
/// reference and its parts. The parts common to all chains (discretisation, sampling) have rows of
/// their own. An asterisk marks a closure that is not ok. The sentence of the limits follows. Empty
/// without a budget.
/// @param format if rows exceed the width, the tail is omitted first, then the parts from the end
///               of the chain
std::string budget_table(const results::Case& case_result, const TextFormat& format);

/// The displayed columns of this table; none without a budget.
std::vector<Column> budget_columns(const results::Case& case_result, const TextFormat& format);

/// The short name of a part, for a narrow header: "trunc.".
std::string part_header(const std::string& part);

}  // namespace fpkcheck::report
