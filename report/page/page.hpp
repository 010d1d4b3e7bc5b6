#pragma once

#include <string>

#include "report/supplement.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Returns the self-contained page report.html, which needs no other file and no network. The page
/// contains the verdict, the problem, one section for each case, the timings and the command of the
/// run. The section of a case has densities, results, findings, error budget, convergence, joint
/// densities and diagnostics. The page omits data that the run did not save.
/// @param supplement texts of a command; the summary is at the top of the page, and the sections
///        precede the problem
std::string page(const results::Run& run, const Supplement& supplement = {});

}  // namespace fpkcheck::report
