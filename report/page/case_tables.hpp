#pragma once

#include <string>

#include "results/run.hpp"

/// The tables of a case on the page, in HTML.
namespace fpkcheck::report {

/// A row per solution: equation and impact, status, moments, distances to the reference and to the
/// other solutions of the full problem, mass, energy residual, seconds.
std::string results_table(const results::Case& case_result);

/// Errors of moments outside the guaranteed bounds: the distance from the midpoint, known to the
/// half-width. Empty without bounds.
std::string bound_errors_table(const results::Case& case_result);

/// Errors of moments estimated from residuals. Empty without such estimates.
std::string residual_errors_table(const results::Case& case_result);

/// The reasons of solutions that are not ok, as a list; empty if all are ok.
std::string reasons_html(const results::Case& case_result);

/// Diagnostics of all solutions: mass, energy residual, error estimates, sampling errors; then the
/// metrics of each family (family_tables.hpp).
std::string diagnostics_tables(const results::Case& case_result);

}  // namespace fpkcheck::report
