#pragma once

#include <string>
#include <vector>

#include "report/text/text_columns.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Returns sentences that explain the headers and cells of the displayed columns of the tables of
/// solutions. The text is empty if no column is displayed.
std::string solutions_table_legend(const std::vector<TextColumn>& results, const results::Run& run);

/// Returns sentences that explain the columns of the tables of error budgets.
std::string budget_table_legend(const std::vector<TextColumn>& budgets);

}  // namespace fpkcheck::report
