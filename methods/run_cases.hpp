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
  std::size_t done;       ///< number of solutions that are finished
  std::size_t total;      ///< number of solutions that the run computes
  std::string case_name;  ///< name of the case that is solved
  std::string method;     ///< id of the method that reports progress
  double fraction;        ///< completed fraction of the work of this method, 0 .. 1
  std::string note = {};  ///< note on the state of this method; may be empty
};

/// Function that receives the progress of a run. Several threads call the function, but never two
/// threads at the same time.
using ProgressListener = std::function<void(const RunProgress&)>;

/// Solves a problem with a method, and sets the identity and options of the solution. If memory
/// does not suffice, the status is `failed`. The solution of a density equation or of a simulation
/// gets a status other than `ok` if the solution has no error estimate. For all other solutions
/// complete_error_estimates() sets this status.
transform::Solution solve_with(const Method& method, const problem::Problem& problem,
                               const SolveContext& context);

/// Tests that the options of every method are compatible with every problem (Method::check).
/// @throws InputError when a method and a problem are incompatible
void require_compatible_options(const std::vector<problem::Problem>& problems,
                                const std::vector<Method>& methods);

/// Calls require_compatible_options(), solves every problem with every method,
/// and compares the solutions of each problem. Methods that use one processor run in parallel.
/// While a method that uses all processors runs, no other method runs.
/// @param methods by increasing trust
/// @param thread_count number of threads; 0 for one per processor
/// @throws the first exception of a solver, after the other solvers have ended
std::vector<results::CaseResult> run_cases(const std::vector<problem::Problem>& problems,
                                           const std::vector<Method>& methods, int thread_count,
                                           const ProgressListener& listener);

/// Function that receives the result of a case as soon as all its solutions are computed. Several
/// threads call the function.
using CaseListener = std::function<void(const results::CaseResult&)>;

/// Solves and compares as the overload without estimators does.
/// @param estimators residual-based error estimators, one for each problem; the caller owns them
/// @param case_listener receives the completed cases; may be empty. If the listener is set, a stop
///        request (base/process/stop_request.hpp) prevents further solves, and the returned list
///        omits the incomplete cases
std::vector<results::CaseResult> run_cases(const std::vector<problem::Problem>& problems,
                                           const std::vector<Method>& methods, int thread_count,
                                           const ProgressListener& listener,
                                           const std::vector<ResidualErrorEstimator>& estimators,
                                           const CaseListener& case_listener);

}  // namespace fpkcheck::methods
