#pragma once

#include <string>

#include "results/run.hpp"

/// The tables of one case.
namespace fpkcheck::report {

/// A row per solution: what it solves, status, moments, distances from the reference and from the
/// other solutions of the problem itself, energy, seconds.
std::string results_table(const results::Case& one);

/// By how much each solution's moments are off, where they are outside the guaranteed bounds: the
/// distance from the middle, known to the half-width. Empty where there are no bounds.
std::string moment_errors_table(const results::Case& one);

/// By how much they are off by their own residuals (results::OwnError). Empty where nobody looked.
std::string own_errors_table(const results::Case& one);

/// Why solutions are not ok, as a list; empty when all are.
std::string reasons_html(const results::Case& one);

/// What can be said of every solution, whoever made it: mass, energy, errors stated and chance;
/// then what each family alone says (family_tables.hpp).
std::string diagnostics_tables(const results::Case& one);

}  // namespace fpkcheck::report
