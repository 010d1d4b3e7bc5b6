#pragma once

#include <span>
#include <string>

#include "compare/budget.hpp"
#include "compare/pairs.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// One sentence that says what limits each closure of a case: the largest part of its budget (both
/// variables together), or the end of its chain, where the closure is nearer to it than the end is
/// known. Closures with the same limit are named together. Says too where the ends of the step called
/// sampling do not agree (compare/agreement.hpp). Empty without a budget.
std::string limits(std::span<const BudgetRow> budget,
                   std::span<const transform::Solution> solutions,
                   std::span<const PairDistances> pairs);

}  // namespace fpkcheck::compare
