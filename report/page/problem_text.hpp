#pragma once

#include <string>

#include "results/run.hpp"

/// Sections of the page that explain the problem, the names and the timings.
namespace fpkcheck::report {

/// Returns the problem in words and formulas with its parameters. A sentence states the parameters
/// that are equal in all cases, and a table shows the varying parameters.
std::string problem_description_html(const results::Run& run);

/// Returns the parameters of a case that differ between the cases of the run, as text: "μ = 1,
/// λE[Y²] = 0.1".
std::string varying_parameters_text(const results::Run& run,
                                    const results::CaseResult& case_result);

/// Returns the glossary of the solutions, equations, impact conditions, columns and statuses in
/// this run.
std::string glossary_html(const results::Run& run);

/// Returns the table of the wall-clock times of each solution in each case, in seconds.
std::string timings_table_html(const results::Run& run);

}  // namespace fpkcheck::report
