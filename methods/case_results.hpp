#pragma once

#include <functional>
#include <vector>

#include "methods/run_cases.hpp"

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

}  // namespace fpkcheck::methods
