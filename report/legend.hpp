#pragma once

#include <string>
#include <vector>

#include "report/text/columns.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Legend of the tables of solutions, in sentences: explains headers and cells of the displayed
/// columns only. Empty without columns.
/// @param results columns of solutions, of all cases
/// @param run     the run with these cases
std::string results_legend(const std::vector<Column>& results, const results::Run& run);

/// Legend of the tables of error budgets.
/// @param budgets columns of error budgets, of all cases
std::string budget_legend(const std::vector<Column>& budgets);

}  // namespace fpkcheck::report
