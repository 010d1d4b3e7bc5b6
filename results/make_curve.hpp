#pragma once

#include "compare/pair_distances.hpp"
#include "results/run.hpp"

namespace fpkcheck::results {

/// Converts a marginal density of a solution to the form in which runs store marginal densities.
Curve make_curve(compare::SolutionMarginal&& found);

}  // namespace fpkcheck::results
