#pragma once

#include <string>

#include "report/supplement.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The self-contained page report.html, which loads no file and uses no network. Contents: verdict;
/// problem; for each case densities, results, findings, error budget, convergence, joint densities
/// and diagnostics; timings and the command of the run. Parts that the run did not save are
/// omitted, such as the joint densities of older runs.
/// @param supplement its summary opens the page, its sections precede the problem
std::string page(const results::Run& run, const Supplement& supplement = {});

}  // namespace fpkcheck::report
