#pragma once

#include <span>
#include <string>

#include "compare/budget.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// One sentence that says what limits each closure of a case: the largest part of its budget (both
/// variables together), or the end of its chain, where the closure is nearer to it than the end is
/// known. Closures with the same limit are named together. Empty without a budget.
std::string limits(std::span<const BudgetRow> budget,
                   std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::compare
