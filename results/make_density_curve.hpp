#pragma once

#include "compare/pair_distances.hpp"
#include "results/run.hpp"

namespace fpkcheck::results {

/// Converts a marginal density of a solution to the form in which runs store marginal densities.
DensityCurve make_density_curve(compare::SolutionMarginal&& marginal);

}  // namespace fpkcheck::results
