#pragma once

#include <string>

#include "problem/problem.hpp"
#include "report/text/format.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The terminal text of a run. The text of a case has a line of parameters, a row for each solution
/// with the distances to the solutions of the full problem (reference first), the reasons for every
/// status other than ok, the error budget and the findings (findings.hpp). A legend of the
/// displayed columns follows all cases (legend.hpp). The text is plain ASCII; a dash marks a
/// missing value.
/// @param format format of the text: if rows exceed its width, the least important columns are
///               omitted, in this order: energy residual, distances to solutions other than the
///               reference, seconds, equation, moments
std::string table(const results::Run& run, const TextFormat& format = {});

/// The name and the parameters of a problem: "case1: c = 0.1, k = 1, ...".
std::string case_title(const problem::Problem& problem);

}  // namespace fpkcheck::report
