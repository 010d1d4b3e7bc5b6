#pragma once

#include <string>
#include <vector>

#include "report/page/plot.hpp"
#include "results/run.hpp"

/// The error budget of a case on the page: the contribution of each approximation to the distance
/// between a closure and the end of its chain of models.
namespace fpkcheck::report {

/// A paragraph that explains plots and tables and names the end of the chain; empty without a
/// budget.
std::string budget_introduction(const results::Case& case_result);

/// A bar plot for each marginal. Empty without a budget.
/// @param prefix of the ids of the plots
std::vector<Plot> budget_plots(const results::Case& case_result, const std::string& prefix);

/// Tables of the same numbers and of the tails.
std::string budget_tables(const results::Case& case_result);

}  // namespace fpkcheck::report
