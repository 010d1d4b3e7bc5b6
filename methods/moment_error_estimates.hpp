#pragma once

#include "methods/residual_error_estimator.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

/// Computes moment error estimates and error sources of a case by the dual-weighted residual method
/// (backward/residual/density_residuals.hpp), for every solution with a density on cells or as a
/// function. A simulation's histogram gets none, since its sampling noise is no residual of an
/// equation. Solutions and error sources are on the physical axes. Where the backward equation
/// cannot be solved, or memory does not suffice, the case gets no estimates.
/// @param estimator of the case's problem
/// @param threads 0 for all processors
void add_moment_error_estimates(results::Case& case_result, const ResidualErrorEstimator& estimator,
                                int threads);

}  // namespace fpkcheck::methods
