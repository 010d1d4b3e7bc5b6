#pragma once

#include <string>

#include "results/run.hpp"

namespace fpkcheck::report {

/// Returns the table of the solutions of a case. Each row has the equation and impact condition,
/// status, moments, distances from the solutions of the full problem, mass, energy residual and
/// wall-clock time.
std::string solutions_table_html(const results::CaseResult& case_result);

/// Returns the table of errors of those moments that are outside the guaranteed bounds. The error
/// of a moment is its distance from the midpoint of the bounds, and the half-width of the bounds is
/// the uncertainty. The table is empty without guaranteed bounds.
std::string bound_errors_table_html(const results::CaseResult& case_result);

/// Returns the table of the residual-based error estimates of moments, or an empty text without
/// estimates.
std::string residual_errors_table_html(const results::CaseResult& case_result);

/// Returns the reasons for every status other than `ok` as HTML. The text is empty if all solutions
/// are `ok`.
std::string status_reasons_html(const results::CaseResult& case_result);

/// Returns the tables of diagnostics. The first table has the mass, energy residual, error
/// estimates and sampling errors of all solutions. Further tables have the metrics of each family
/// of methods (metric_tables.hpp).
std::string diagnostics_tables_html(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
