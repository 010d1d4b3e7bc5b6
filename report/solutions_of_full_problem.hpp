#pragma once

#include <string>
#include <vector>

#include "results/run.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::report {

/// Returns the solutions of the full problem, with which tables and sentences compare all other
/// solutions. The reference of the case is the first element. All further solutions have their
/// order in the case. The list is empty if the case has no reference.
std::vector<const transform::Solution*> solutions_of_full_problem(
    const results::CaseResult& case_result);

/// Returns a sentence on the reference and the reason for its selection.
std::string describe_reference(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
