#pragma once

#include "compare/bounds.hpp"
#include "dual/bounds/bounds.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

/// dual::bounds() as comparisons and files know them; without memory for them there are none, for
/// that reason.
compare::Bounds guaranteed_bounds(const problem::Problem& problem, const dual::Options& options);

/// Gives a case its bounds, as narrow as about a second allows.
/// @param threads 0 for all processors
void add_bounds(results::Case& one, int threads);

}  // namespace fpkcheck::methods
