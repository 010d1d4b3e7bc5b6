#pragma once

#include <string>

#include "results/run.hpp"

/// The tables of a case on the page, in HTML.
namespace fpkcheck::report {

/// The table of the solutions of a case. The row of a solution has equation and impact condition,
/// status, moments, distances to the reference and to the other solutions of the full problem,
/// mass, energy residual and seconds.
std::string results_table(const results::CaseResult& case_result);

/// The table of the errors of those moments that lie outside the guaranteed bounds. The error of
/// such a moment is the distance to the midpoint of the bounds, with the half-width of the bounds
/// as uncertainty. The table is empty if the case has no guaranteed bounds.
std::string bound_errors_table(const results::CaseResult& case_result);

/// The table of the moment errors, as estimated from residuals of the density. The table is empty
/// if the case has no error estimates from residuals.
std::string residual_errors_table(const results::CaseResult& case_result);

/// The list of the reasons why solutions are not ok; empty if all solutions are ok.
std::string reasons_html(const results::CaseResult& case_result);

/// The tables of diagnostics: first mass, energy residual, error estimates and sampling errors of
/// all solutions, then the metrics of each family (family_tables.hpp).
std::string diagnostics_tables(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
