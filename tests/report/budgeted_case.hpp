#pragma once

#include <limits>

#include "page/made_up_page.hpp"

namespace fpkcheck::tests {

/// A case with the budgets of two closures in both marginals; the second closure is not ok.
inline results::CaseResult budgeted_case() {
  auto case_result = whole_case();
  case_result.budget.clear();
  for (const auto variable : transform::kVariables) {
    compare::ErrorBudgetRow row{.solution = "epc-gaussian-n6",
                                .variable = variable,
                                .reference = "mcs",
                                .total = 0.0024,
                                .total_tail = 0.23,
                                .tail_from = 1e-5,
                                .tail_to = 1e-3,
                                .tail_bins = 17,
                                .parts = {}};
    row.parts = {{.approximations = {compare::ModelApproximation::closure},
                  .from = "epc-gaussian-n6",
                  .to = "fd-km4-delta",
                  .l1 = 0.00231,
                  .tail = 0.21,
                  .uncertainty = 0.00004},
                 {.approximations = {compare::ModelApproximation::impact},
                  .from = "fd-km4-delta",
                  .to = "fd-km4",
                  .l1 = std::numeric_limits<double>::quiet_NaN(),
                  .tail = std::numeric_limits<double>::quiet_NaN()},
                 {.approximations = {compare::ModelApproximation::sampling},
                  .from = "fd-kf limit",
                  .to = "mcs",
                  .l1 = 0.00047,
                  .tail = 0.02,
                  .expected = 0.00059,
                  .quantile_99 = 0.00081}};
    case_result.budget.push_back(row);
    row.solution = "epc-gaussian-n4";
    row.parts.erase(row.parts.begin() + 1);
    case_result.budget.push_back(row);
  }
  return case_result;
}

}  // namespace fpkcheck::tests
