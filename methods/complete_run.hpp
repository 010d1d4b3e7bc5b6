#pragma once

#include <functional>
#include <vector>

#include "methods/run_cases.hpp"

namespace fpkcheck::methods {

/// How a complete run is done, and who is told of it.
struct CompleteRun {
  int threads = 0;        ///< for methods side by side; 0 for all processors
  bool with_dual = true;  ///< bounds, and every density's own error, by the backward equation
  ProgressListener progress = {};
  /// Told of a case when it has all its solutions, and again when it has bounds and own errors. If
  /// there is one, nothing more is solved when the program is told to stop, as in run_cases.
  CaseListener case_listener = {};
  /// Asked between two things that take long, after the solutions; what it throws ends the run.
  std::function<void()> look = {};
};

/// Solves, compares, bounds, and measures own errors: all that the cases of a run have.
/// @throws whatever a solver, `progress` or `look` throws
std::vector<results::Case> complete_run(const std::vector<problem::Problem>& problems,
                                        const std::vector<Method>& methods, const CompleteRun& how);

}  // namespace fpkcheck::methods
