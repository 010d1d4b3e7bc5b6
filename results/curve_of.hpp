#pragma once

#include "compare/pairs.hpp"
#include "results/run.hpp"

namespace fpkcheck::results {

/// What is saved of a marginal.
Curve curve_of(compare::SolutionMarginal&& found);

}  // namespace fpkcheck::results
