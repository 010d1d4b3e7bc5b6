#pragma once

#include <string>

#include "results/run.hpp"

/// Texts of the page on the problem, the names and the timings.
namespace fpkcheck::report {

/// The problem in words and formulas with its parameters: those equal in all cases in a sentence,
/// the others in a table.
std::string problem_html(const results::Run& run);

/// The parameters of a case that differ between the cases of the run: "μ = 1, λE[Y²] = 0.1".
std::string varying_parameters(const results::Run& run, const results::Case& case_result);

/// The glossary of this run: names of solutions, equations, impacts, columns, statuses.
std::string glossary_html(const results::Run& run);

/// The seconds of each solution in each case.
std::string timings_table(const results::Run& run);

}  // namespace fpkcheck::report
