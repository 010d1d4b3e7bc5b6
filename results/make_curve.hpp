#pragma once

#include "compare/pairs.hpp"
#include "results/run.hpp"

namespace fpkcheck::results {

/// Converts a marginal to the curve that is saved.
Curve make_curve(compare::SolutionMarginal&& found);

}  // namespace fpkcheck::results
