#pragma once

#include <functional>
#include <string>
#include <vector>

#include "methods/method.hpp"
#include "methods/residual_error_estimator.hpp"
#include "problem/problem.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

/// The progress of a run.
struct RunProgress {
  std::size_t done;   ///< solutions finished
  std::size_t total;  ///< solutions requested
  std::string case_name;
  std::string method;
  double fraction;        ///< of this method's work; 1 when the method has just finished
  std::string note = {};  ///< the method's note on its state; may be empty
};

/// Receives progress. Several threads call it, never two at the same time.
using ProgressListener = std::function<void(const RunProgress&)>;

/// Solves a problem with a method on the axes of its case, and sets the solution's identity and
/// options. Where memory does not suffice, the status is `failed`. A solution of a density equation
/// or a simulation without an error estimate is not `ok`; complete_error_estimates() does the same
/// for all others.
transform::Solution solve_with(const Method& method, const problem::Problem& problem,
                               const SolveContext& context);

/// @throws InputError when the options of a method do not suit one of the problems (Method::check)
void require_solvable(const std::vector<problem::Problem>& problems,
                      const std::vector<Method>& methods);

/// Solves every problem with every method and compares the solutions, after require_solvable().
/// Methods that use one processor run in parallel; methods that use all processors run alone.
/// @param methods by increasing trust
/// @param threads processors to use; 0 for all
/// @throws whatever a solver throws, after the other solvers have ended
std::vector<results::Case> run_cases(const std::vector<problem::Problem>& problems,
                                     const std::vector<Method>& methods, int threads,
                                     const ProgressListener& listener);

/// Receives a case as soon as it has all its solutions. Several threads call it.
using CaseListener = std::function<void(const results::Case&)>;

/// Does the same with error estimators that the caller owns, one for each problem.
/// @param case_listener if set, a stop request (base/process/stop.hpp) prevents further solves, and
///                      the returned list lacks the incomplete cases
std::vector<results::Case> run_cases(const std::vector<problem::Problem>& problems,
                                     const std::vector<Method>& methods, int threads,
                                     const ProgressListener& listener,
                                     const std::vector<ResidualErrorEstimator>& estimators,
                                     const CaseListener& case_listener);

}  // namespace fpkcheck::methods
