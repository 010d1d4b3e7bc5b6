#pragma once

#include "compare/pair_distances.hpp"
#include "results/run.hpp"

namespace fpkcheck::results {

/// Converts the marginal density of a solution to a curve, the form in which a run stores it.
Curve make_curve(compare::SolutionMarginal&& found);

}  // namespace fpkcheck::results
