#pragma once

#include <vector>

#include "results/run.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::report {

/// The solutions of the full problem, with which tables and sentences compare all others: first the
/// reference of the case, then the rest in the order of the case. Empty without a reference.
std::vector<const transform::Solution*> references(const results::Case& case_result);

}  // namespace fpkcheck::report
