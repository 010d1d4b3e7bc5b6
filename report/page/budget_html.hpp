#pragma once

#include <string>

#include "results/run.hpp"

/// The error budget of a case on the page: the contribution of each approximation to the L1
/// distance between a closure and the reference of the budget.
namespace fpkcheck::report {

/// Returns a paragraph that explains the figure and tables of the error budget, and names the
/// reference of the total distances. The paragraph is empty if the case has no error budget.
std::string budget_introduction_html(const results::CaseResult& case_result);

/// Returns HTML tables of the L1 distances and the tail distances in the error budget.
std::string budget_tables_html(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
