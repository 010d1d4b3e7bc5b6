#pragma once

#include <string>
#include <vector>

#include "report/text/columns.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// What the headers and cells of the tables mean, in sentences: of the columns that are shown, and
/// nothing else. Empty when there are none.
/// @param results columns of solutions, of all cases
/// @param run of these cases
std::string results_legend(const std::vector<Column>& results, const results::Run& run);

/// @param budgets columns of error budgets, of all cases
std::string budget_legend(const std::vector<Column>& budgets);

}  // namespace fpkcheck::report
