#pragma once

#include <functional>
#include <vector>

#include "backward/bounds/bounds.hpp"
#include "compare/guaranteed_bounds.hpp"
#include "methods/residual_error_estimator.hpp"
#include "methods/run_cases.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

struct CaseResultSettings {
  int threads = 0;  ///< number of threads for parallel methods; 0 for one per processor
  /// Whether to solve backward equations, for guaranteed bounds and moment error estimates.
  bool with_backward = true;
  ProgressListener progress = {};
  /// Function that receives the result of a case after the solutions are computed, and again after
  /// guaranteed bounds and moment error estimates. If a case listener is set, a stop request
  /// prevents the computation of further solutions, as in run_cases().
  CaseListener case_listener = {};
  /// Function that several threads call after the computation of the solutions and after each
  /// further long operation. An exception of the function `poll` ends the computation of the case
  /// results.
  std::function<void()> poll = {};
};

/// Solves all problems with all methods, and computes comparisons, guaranteed bounds and moment
/// error estimates.
/// @throws all exceptions of the solvers and of the functions `progress` and `poll`
std::vector<results::CaseResult> compute_case_results(const std::vector<problem::Problem>& problems,
                                                      const std::vector<Method>& methods,
                                                      const CaseResultSettings& settings);

/// Computes guaranteed bounds by backward::compute_guaranteed_bounds(). If memory does not suffice,
/// the returned GuaranteedBounds contain no bounds, and the `reason` kOutOfMemory.
compare::GuaranteedBounds compute_guaranteed_bounds(const problem::Problem& problem,
                                                    const backward::BoundsOptions& options);

/// Computes moment error estimates and error sources of solutions by the dual-weighted residual
/// method (backward/residual/density_error_estimator.hpp). Only solutions whose density is a
/// function, or averages over cells of a finite-volume method, get moment error estimates. A
/// histogram of a simulation gets no moment error estimate, since sampling noise is not a residual
/// of an equation. If the backward equation cannot be solved or memory does not suffice, no
/// solution gets a moment error estimate.
/// @param thread_count number of threads; 0 for one per processor
void add_moment_error_estimates(results::CaseResult& case_result,
                                const ResidualErrorEstimator& estimator, int thread_count);

}  // namespace fpkcheck::methods
