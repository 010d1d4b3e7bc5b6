#pragma once

#include <string>

#include "report/supplement.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// report.html: one page that needs nothing but itself, neither files nor the network. The problem
/// in words and numbers; for each case the solutions, what they say, densities, joint densities,
/// error budget, convergence and diagnostics; timings, and the command that repeats the run.
/// Parts that the run did not save, as the joint densities of older ones, are left out.
/// @param supplement its summary opens the page, its sections stand before the problem
std::string page(const results::Run& run, const Supplement& supplement = {});

}  // namespace fpkcheck::report
