#pragma once

#include <string>

#include "problem/problem.hpp"
#include "report/text/format.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The terminal text of a run. Each case has a line of parameters, a row per solution with the
/// distances to the solutions of the full problem (reference first), the reasons of solutions that
/// are not ok, the error budget and the findings (findings.hpp). The legend of the displayed
/// columns follows (legend.hpp). Plain ASCII; a dash marks a missing value.
/// @param format if rows exceed the width, the least important columns are omitted: first the
///               energy residual, then the distances to solutions other than the reference, the
///               seconds, the equation, the moments
std::string table(const results::Run& run, const TextFormat& format = {});

/// Name and parameters of a problem: "case1: c = 0.1, k = 1, ...".
std::string case_title(const problem::Problem& problem);

}  // namespace fpkcheck::report
