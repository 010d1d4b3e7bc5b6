#pragma once

#include <string>

#include "results/run.hpp"

/// Sections of the page that explain the problem, the names and the timings.
namespace fpkcheck::report {

/// The problem in words and formulas, with the parameters. A sentence states the parameters that
/// are equal in all cases, and a table shows the other parameters.
std::string problem_html(const results::Run& run);

/// The text of those parameters of a case that differ between the cases of the run: "μ = 1, λE[Y²]
/// = 0.1".
std::string varying_parameters(const results::Run& run, const results::CaseResult& case_result);

/// The glossary of the names in this run: names of solutions, equations, impact conditions, columns
/// and statuses.
std::string glossary_html(const results::Run& run);

/// The table of the wall-clock seconds of each solution in each case.
std::string timings_table(const results::Run& run);

}  // namespace fpkcheck::report
