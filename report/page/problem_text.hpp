#pragma once

#include <string>

#include "results/run.hpp"

/// What was solved, and how.
namespace fpkcheck::report {

/// The system in words and formulas, and its numbers: those that all cases share in a sentence, the
/// others in a table.
std::string problem_html(const results::Run& run);

/// The parameters of a case in which the cases of the run differ: "μ = 1, λE[Y²] = 0.1".
std::string what_varies(const results::Run& run, const results::Case& one);

/// What the names of solutions, equations, impacts and columns mean: those of this run.
std::string glossary_html(const results::Run& run);

/// The seconds of each solution in each case.
std::string timings_table(const results::Run& run);

}  // namespace fpkcheck::report
