#pragma once

#include <span>
#include <string>

#include "compare/budget.hpp"
#include "compare/pairs.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// A sentence on the limiting error of each closure of a case: the largest part of its budget,
/// summed over both variables, or none if its distance is within the error of the reference.
/// Closures with the same limiting error are grouped. A second sentence reports a disagreement of
/// the two ends of the part `sampling` (compare/agreement.hpp). Empty without a budget.
std::string limits(std::span<const BudgetRow> budget,
                   std::span<const transform::Solution> solutions,
                   std::span<const PairDistances> pairs);

}  // namespace fpkcheck::compare
