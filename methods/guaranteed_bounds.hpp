#pragma once

#include "backward/bounds/bounds.hpp"
#include "compare/guaranteed_bounds.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

/// Computes guaranteed bounds by backward::bounds() and converts them to the type that comparisons
/// and files use. If memory does not suffice, the result has no bounds, and its `reason` is
/// kOutOfMemory.
compare::GuaranteedBounds guaranteed_bounds(const problem::Problem& problem,
                                            const backward::Options& options);

/// Computes the guaranteed bounds of a case and stores them in the result of the case. The
/// refinement of the bounds ends after about a second.
/// @param thread_count number of threads; 0 for one per processor
void add_guaranteed_bounds(results::CaseResult& case_result, int thread_count);

}  // namespace fpkcheck::methods
