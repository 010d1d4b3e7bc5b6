#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "report/text/text_layout.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Returns the text on a run for the terminal, in plain ASCII. The terminal text of a case has the
/// parameters, a table of the solutions, the reasons for every status other than `ok`, the error
/// budget and the findings (findings.hpp). The table row of a solution has the distances from the
/// solutions of the full problem. A legend of the displayed table columns follows the texts of all
/// cases. A dash in a table marks a missing value.
/// @param format format of the text; if table rows exceed the text width, columns are omitted in
///        this order: energy residual, distances from solutions other than the reference, seconds,
///        equation, moments
std::string terminal_tables_text(const results::Run& run, const TerminalTextFormat& format = {});

/// Returns the name and the parameters of a problem: "case1: c = 0.1, k = 1, ...".
std::string case_title(const problem::Problem& problem);

/// Returns the error budget of a case as a text table. For each closure and marginal density the
/// table has the L1 distance from the reference and the parts of this L1 distance. Budget parts
/// that are equal for all closures (discretisation, sampling) have separate rows. In the error
/// budget table an asterisk marks a closure with a status other than `ok`. A sentence below the
/// error budget table states the limitations of the error budget. The returned text is empty if the
/// case has no error budget.
/// @param format format of the text; if table rows exceed the text width, the columns of tail
///        distances are omitted first, then the columns of the last budget parts
std::string error_budget_table_text(const results::CaseResult& case_result,
                                    const TerminalTextFormat& format);

/// Returns the columns that error_budget_table_text() displays in a text format. The returned list
/// of columns is empty if the case has no error budget.
std::vector<TextTableColumn> displayed_budget_columns(const results::CaseResult& case_result,
                                                      const TerminalTextFormat& format);

/// Returns the short name of a part of the error budget for the header of a narrow column:
/// "trunc.".
std::string error_budget_part_header(const std::string& part);

/// Returns sentences that explain the headers and cells of the displayed columns of the tables of
/// solutions. The returned text is empty if no table column is displayed.
std::string solutions_table_legend(const std::vector<TextTableColumn>& results,
                                   const results::Run& run);

/// Returns sentences that explain the columns of the tables of error budgets.
std::string error_budget_table_legend(const std::vector<TextTableColumn>& budgets);

}  // namespace fpkcheck::report
