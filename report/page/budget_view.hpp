#pragma once

#include <string>
#include <vector>

#include "report/page/plot.hpp"
#include "results/run.hpp"

/// The error budget of a case on the page: the contribution of each approximation to the L1
/// distance between a closure and the most accurate solution of the budget.
namespace fpkcheck::report {

/// A paragraph that explains the plots and tables of the error budget, and names the solution to
/// which the total distances refer. The paragraph is empty if the case has no error budget.
std::string budget_introduction(const results::CaseResult& case_result);

/// Makes a bar plot of the error budget for each marginal density; no plot if the case has no error
/// budget.
/// @param prefix prefix of the ids of the plots
std::vector<Plot> budget_plots(const results::CaseResult& case_result, const std::string& prefix);

/// HTML tables of the L1 distances and the tail distances of the error budget.
std::string budget_tables(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
