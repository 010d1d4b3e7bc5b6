#pragma once

#include "backward/bounds/bounds.hpp"
#include "compare/bounds.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

/// Converts backward::bounds() to the type that comparisons and files use. Where memory does not
/// suffice, the result has no bounds and gives that reason.
compare::Bounds guaranteed_bounds(const problem::Problem& problem,
                                  const backward::Options& options);

/// Computes the guaranteed bounds of a case, as narrow as about a second allows.
/// @param threads 0 for all processors
void add_bounds(results::Case& case_result, int threads);

}  // namespace fpkcheck::methods
