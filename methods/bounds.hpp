#pragma once

#include "backward/bounds/bounds.hpp"
#include "compare/bounds.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

/// backward::bounds() as comparisons and files know them; without memory for them there are none, for
/// that reason.
compare::Bounds guaranteed_bounds(const problem::Problem& problem,
                                  const backward::Options& options);

/// Gives a case its bounds, as narrow as about a second allows.
/// @param threads 0 for all processors
void add_bounds(results::Case& one, int threads);

}  // namespace fpkcheck::methods
