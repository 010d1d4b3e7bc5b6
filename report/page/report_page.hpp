#pragma once

#include <string>

#include "report/supplement.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Returns the self-contained page report.html, which needs no other file and no network. The page
/// contains the verdict, the problem, one section for each case, the timings and the command of the
/// run. The section of a case has densities, results, findings, error budget, convergence, joint
/// densities and diagnostics. Data that the run did not save are omitted.
/// @param supplement texts of a command. The summary is at the top of the page, and the sections
/// precede the description of the problem.
std::string report_page_html(const results::Run& run, const Supplement& supplement = {});

}  // namespace fpkcheck::report
