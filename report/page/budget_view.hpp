#pragma once

#include <string>

#include "results/run.hpp"

/// The error budget of a case on the page: the contribution of each approximation to the L1
/// distance between a closure and the reference of the budget.
namespace fpkcheck::report {

/// A paragraph that explains the figure and the tables of the error budget, and names the solution to
/// which the total distances refer. The paragraph is empty if the case has no error budget.
std::string budget_introduction(const results::CaseResult& case_result);

/// HTML tables of the L1 distances and the tail distances of the error budget.
std::string budget_tables(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
