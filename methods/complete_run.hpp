#pragma once

#include <functional>
#include <vector>

#include "methods/run_cases.hpp"

namespace fpkcheck::methods {

/// Settings and callbacks of a complete run.
struct CompleteRunSettings {
  int threads = 0;            ///< for methods that run in parallel; 0 for all processors
  bool with_backward = true;  ///< compute bounds and moment error estimates (backward equation)
  ProgressListener progress = {};
  /// Called when a case has all its solutions, and again when it has bounds and moment error
  /// estimates. If set, a stop request prevents further solves, as in run_cases.
  CaseListener case_listener = {};
  /// Called between two long operations after the solutions; an exception from it ends the run.
  std::function<void()> poll = {};
};

/// Solves and compares the cases of a run, and computes their bounds and moment error estimates.
/// @throws whatever a solver, `progress` or `poll` throws
std::vector<results::Case> complete_run(const std::vector<problem::Problem>& problems,
                                        const std::vector<Method>& methods,
                                        const CompleteRunSettings& settings);

}  // namespace fpkcheck::methods
