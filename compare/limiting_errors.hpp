#pragma once

#include <span>
#include <string>

#include "compare/error_budget.hpp"
#include "compare/pair_distances.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// A sentence on the limiting error of each closure of a case. The limiting error is the largest
/// part of the closure's error budget, summed over both variables. A closure whose distance from
/// the reference is within the error of the reference has no limiting error. Closures with the same
/// limiting error are grouped. A second sentence follows if the finite-volume solution and the
/// simulation disagree (compare/agreement.hpp). The text is empty without an error budget.
std::string limiting_errors_text(std::span<const ErrorBudgetRow> budget,
                                 std::span<const transform::Solution> solutions,
                                 std::span<const PairDistances> pairs);

}  // namespace fpkcheck::compare
