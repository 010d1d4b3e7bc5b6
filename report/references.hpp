#pragma once

#include <string>
#include <vector>

#include "results/run.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::report {

/// The solutions of the full problem, with which tables and sentences compare all other solutions.
/// The reference of the case is the first element; the remaining solutions have the order of the
/// case. The list of solutions is empty if the case has no reference.
std::vector<const transform::Solution*> references(const results::CaseResult& case_result);

/// A sentence on the id of the reference and the reason for its selection.
std::string reference_text(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
