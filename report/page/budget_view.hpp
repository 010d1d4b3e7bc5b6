#pragma once

#include <string>
#include <vector>

#include "report/page/plot.hpp"
#include "results/run.hpp"

/// The error budget of a case: what each approximation adds to a closure's distance from the truth.
namespace fpkcheck::report {

/// What the plots and tables show, with the chain's end; empty without a budget.
std::string budget_introduction(const results::Case& one);

/// Bars: a plot for each variable. None without a budget.
std::vector<Plot> budget_plots(const results::Case& one, const std::string& prefix);

/// The same numbers and those of the tails as tables.
std::string budget_tables(const results::Case& one);

}  // namespace fpkcheck::report
