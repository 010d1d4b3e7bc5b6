#pragma once

#include <string>

#include "problem/problem.hpp"
#include "report/text/format.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Returns the terminal text of a run, in plain ASCII. The text of a case has the parameters, one
/// row for each solution with its distances from the solutions of the full problem, the reasons for
/// every status other than `ok`, the error budget and the findings (findings.hpp). A legend of the
/// displayed columns follows all cases (legend.hpp). A dash marks a missing value.
/// @param format if rows exceed its width, the least important columns are omitted in this order:
///        energy residual, distances from solutions other than the reference, seconds, equation,
///        moments
std::string table(const results::Run& run, const TextFormat& format = {});

/// Returns the name and the parameters of a problem: "case1: c = 0.1, k = 1, ...".
std::string case_title(const problem::Problem& problem);

}  // namespace fpkcheck::report
