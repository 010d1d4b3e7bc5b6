#pragma once

#include "methods/problem_residuals.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

/// Gives every solution of a case that has a density on cells or as a function its own error, and
/// where that comes from, by dual-weighted residuals (backward/residual/density_residuals.hpp). A
/// simulation's histogram has none: its noise is no error of an equation. Solutions
/// and maps are on the physical axes. Where the backward equation is not solved, or there is no memory for it, there are none.
/// @param residuals of the case's problem
/// @param threads 0 for all processors
void add_own_errors(results::Case& one, const ProblemResiduals& residuals, int threads);

}  // namespace fpkcheck::methods
