#pragma once

#include <string>

#include "results/run.hpp"

/// The head of the page: what was solved, how, and what came out, before any details.
namespace fpkcheck::report {

/// The system in words and formulas, and its numbers in each case.
std::string problem_html(const results::Run& run);

/// What the names of solutions, equations, impacts and columns mean: those of this run.
std::string glossary_html(const results::Run& run);

/// A row per case: the reference and its moments, how far the most trusted other solution of the
/// problem itself is from it, the closest closure, or those of which none can be called so.
std::string overview_table(const results::Run& run);

/// The seconds of each solution in each case.
std::string timings_table(const results::Run& run);

}  // namespace fpkcheck::report
