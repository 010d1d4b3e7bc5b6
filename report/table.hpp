#pragma once

#include <string>

#include "problem/problem.hpp"
#include "report/text/format.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The terminal table of a run: for each case a line of parameters, a row per solution with its
/// distances to the solutions of the problem itself (the reference first), the reasons of the
/// solutions that are not ok, the error budget, and what the distances say (findings.hpp); in the
/// end what the columns that are shown mean (legend.hpp). Plain ASCII, a dash for what is absent.
/// @param format where the rows do not fit, the least important columns go: the energy residual,
///               then the distances to others than the reference, the seconds, the equation, the
///               moments
std::string table(const results::Run& run, const TextFormat& format = {});

/// The line of parameters: "case1: c = 0.1, k = 1, ...".
std::string case_title(const problem::Problem& problem);

}  // namespace fpkcheck::report
