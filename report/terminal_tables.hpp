#pragma once

#include <string>

#include "problem/problem.hpp"
#include "report/text/text_format.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Returns the terminal text of a run, in plain ASCII. The text of a case has the parameters, a
/// table of the solutions, the reasons for every status other than `ok`, the error budget and the
/// findings (findings.hpp). The row of a solution in the table has its distances from the solutions
/// of the full problem. A legend of the displayed columns follows all cases (legend.hpp). A dash
/// marks a missing value.
/// @param format format of the text; if rows exceed its width, columns are omitted in this order:
///        energy residual, distances from solutions other than the reference, seconds, equation,
///        moments
std::string terminal_tables_text(const results::Run& run, const TextFormat& format = {});

/// Returns the name and the parameters of a problem: "case1: c = 0.1, k = 1, ...".
std::string case_title(const problem::Problem& problem);

}  // namespace fpkcheck::report
