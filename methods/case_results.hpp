#pragma once

#include <functional>
#include <vector>

#include "backward/bounds/bounds.hpp"
#include "compare/guaranteed_bounds.hpp"
#include "methods/residual_error_estimator.hpp"
#include "methods/run_cases.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

/// Settings and callbacks of compute_case_results().
struct CaseResultSettings {
  int threads = 0;  ///< number of threads for methods that run in parallel; 0 for one per processor
  /// Whether to solve backward equations for guaranteed bounds and moment error estimates.
  bool with_backward = true;
  ProgressListener progress = {};  ///< receives the progress of the run
  /// Called when all solutions of a case are computed, and again when its bounds and moment error
  /// estimates are computed. If the listener is set, a stop request prevents further solves, as in
  /// run_cases().
  CaseListener case_listener = {};
  /// Called after the solutions are computed, and after each further long operation. An exception
  /// of `poll` ends the run.
  std::function<void()> poll = {};
};

/// Solves all problems with all methods, compares the solutions of each case, and computes
/// guaranteed bounds and moment error estimates of each case.
/// @throws exceptions of solvers, of `progress` and of `poll`
std::vector<results::CaseResult> compute_case_results(const std::vector<problem::Problem>& problems,
                                                      const std::vector<Method>& methods,
                                                      const CaseResultSettings& settings);

/// Computes guaranteed bounds by backward::bounds() and converts them to the type that comparisons
/// and files use. If memory does not suffice, the result has no bounds, and its `reason` is
/// kOutOfMemory.
compare::GuaranteedBounds guaranteed_bounds(const problem::Problem& problem,
                                            const backward::Options& options);

/// Computes the guaranteed bounds of a case and stores them in the result of the case. The
/// refinement of the bounds ends after about a second.
/// @param thread_count number of threads; 0 for one per processor
void add_guaranteed_bounds(results::CaseResult& case_result, int thread_count);

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
