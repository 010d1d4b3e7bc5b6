#pragma once

#include <string>
#include <vector>

#include "compare/error_budget.hpp"
#include "report/text/text_columns.hpp"
#include "report/text/text_format.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Returns the error budget of a case as a text table. Each closure and marginal density has the L1
/// distance from the reference and the parts of this distance. Budget parts that are equal for all
/// closures (discretisation, sampling) have separate rows. An asterisk marks a closure with a
/// status other than `ok`. A sentence below the table states the limitations of the error budget.
/// The text is empty if the case has no error budget.
/// @param format format of the text; if rows exceed its width, the columns of tail distances are
/// omitted first, then the columns of the last budget parts
std::string budget_table_text(const results::CaseResult& case_result, const TextFormat& format);

/// Returns the columns that budget_table_text() displays in a text format. The list is empty if the
/// case has no error budget.
std::vector<TextColumn> displayed_budget_columns(const results::CaseResult& case_result,
                                                 const TextFormat& format);

/// Returns the short name of a part of the error budget for the header of a narrow column:
/// "trunc.".
std::string budget_part_header(const std::string& part);

}  // namespace fpkcheck::report
