#pragma once

#include <string>
#include <vector>

#include "compare/error_budget.hpp"
#include "report/text/columns.hpp"
#include "report/text/format.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The error budget of a case as a text table: for each closure and marginal density the L1
/// distance to the reference and the parts of this distance. The parts that all closures share
/// (discretisation, sampling) have rows of their own. An asterisk marks a closure whose status is
/// not ok. Below the table a sentence states the limitations of the error budget. The text of the
/// table is empty if the case has no error budget.
/// @param format format of the text: if rows exceed its width, the columns of the tail distances
///               are omitted first, then the columns of the last parts
std::string budget_table(const results::CaseResult& case_result, const TextFormat& format);

/// The columns that budget_table displays in a text format; none if the case has no error budget.
std::vector<TextColumn> budget_columns(const results::CaseResult& case_result,
                                       const TextFormat& format);

/// The short name of a part of the error budget for the header of a narrow column: "trunc.".
std::string budget_part_header(const std::string& part);

}  // namespace fpkcheck::report
