#pragma once

#include <string>

#include "report/supplement.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The self-contained page report.html, which loads no file and uses no network. The page contains
/// the verdict, the problem, a section for each case, the timings and the command of the run. The
/// section of a case has densities, results, findings, error budget, convergence, joint densities
/// and diagnostics. The page omits data that the run did not save, such as the joint densities of
/// older runs.
/// @param supplement supplement whose summary is at the top of the page and whose sections precede
///                   the problem
std::string page(const results::Run& run, const Supplement& supplement = {});

}  // namespace fpkcheck::report
