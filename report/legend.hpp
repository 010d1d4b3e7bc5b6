#pragma once

#include <string>
#include <vector>

#include "report/text/columns.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The legend of the tables of solutions, in sentences that explain headers and cells of the
/// displayed columns. The legend is empty if no column is displayed.
/// @param results columns of the tables of solutions of all cases
/// @param run     the run with these cases
std::string results_legend(const std::vector<TextColumn>& results, const results::Run& run);

/// The legend of the tables of error budgets, in sentences.
/// @param budgets columns of the tables of error budgets of all cases
std::string budget_legend(const std::vector<TextColumn>& budgets);

}  // namespace fpkcheck::report
