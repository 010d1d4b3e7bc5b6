#pragma once

#include "methods/residual_error_estimator.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

/// Computes moment error estimates and error sources of the solutions of a case by the
/// dual-weighted residual method (backward/residual/density_residuals.hpp). The solutions with
/// estimates are those with a density on cells or as a function. The histogram of a simulation gets
/// no estimate, since sampling noise is not a residual of an equation. Solutions and error sources
/// are in physical coordinates. If the backward equation cannot be solved, or memory does not
/// suffice, the case gets no estimates.
/// @param estimator residual-based error estimator of the problem of the case
/// @param thread_count number of threads; 0 for one per processor
void add_moment_error_estimates(results::CaseResult& case_result,
                                const ResidualErrorEstimator& estimator, int thread_count);

}  // namespace fpkcheck::methods
