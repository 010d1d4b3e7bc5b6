#pragma once

#include <functional>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "compare/comparison.hpp"
#include "methods/method_interface.hpp"
#include "methods/residual_error_estimator.hpp"
#include "problem/problem.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

struct RunProgress {
  std::size_t done;       ///< number of finished solutions
  std::size_t total;      ///< number of solutions to compute
  std::string case_name;  ///< name of the current case
  std::string method;
  double fraction;        ///< completed fraction of the work of the current method, 0 .. 1
  std::string note = {};  ///< note on the state of the current method; may be empty
};

/// Function that receives the progress of a run. Several threads call the progress listener, but
/// never at the same time.
using ProgressListener = std::function<void(const RunProgress&)>;

/// Solves a problem with a method, and sets the identity and options of the solution. If memory
/// does not suffice, the status of the solution is `failed`. A discretised density equation or a
/// simulation without an error estimate gets a status other than `ok`. For closures and external
/// densities, complete_error_estimates() later sets the final status of the solution.
transform::Solution solve_with_method(const Method& method, const problem::Problem& problem,
                                      const SolverInputContext& context);

/// @throws InputError if a method and a problem are incompatible (Method::check)
void require_compatible_options(const std::vector<problem::Problem>& problems,
                                const std::vector<Method>& methods);

/// Calls require_compatible_options(), solves every problem with every method, and compares the
/// solutions of each problem. Methods that use one processor run in parallel; a method that uses
/// all processors runs alone.
/// @param methods by increasing trust
/// @param thread_count number of threads; 0 for one per processor
/// @throws the first exception of a solver, after the other solvers have ended
std::vector<results::CaseResult> run_cases(const std::vector<problem::Problem>& problems,
                                           const std::vector<Method>& methods, int thread_count,
                                           const ProgressListener& listener);

/// Function that receives the result of a case as soon as all solutions of the case are computed.
/// Several threads may call the case listener.
using CaseListener = std::function<void(const results::CaseResult&)>;

/// Solves every problem with every method and compares the solutions of each problem, with given
/// residual-based error estimators.
/// @param estimators residual-based error estimators, one for each problem; the caller owns them
/// @param case_listener function that receives the completed cases; may be empty. If
/// `case_listener` is set, a stop request (base/process/stop_request.hpp) prevents the computation
/// of further solutions, and the returned list omits incomplete cases.
std::vector<results::CaseResult> run_cases(const std::vector<problem::Problem>& problems,
                                           const std::vector<Method>& methods, int thread_count,
                                           const ProgressListener& listener,
                                           const std::vector<ResidualErrorEstimator>& estimators,
                                           const CaseListener& case_listener);

/// Reason for a missing solution or missing guaranteed bounds if memory does not suffice.
inline constexpr const char* kOutOfMemory =
    "out of memory: the machine or the limit of this process has too little; use coarser grids or "
    "fewer threads";

/// Calls a task of a run and catches exceptions due to a lack of memory. Stack unwinding frees the
/// memory of a failed task, so that all other tasks can continue. A failure to start a thread also
/// counts as a lack of memory, since the operating system could not allocate the stack of the
/// thread.
/// @return whether the task returned without an exception due to a lack of memory
/// @throws any other exception of the task
template <class Function>
bool run_unless_out_of_memory(const Function& function) {
  try {
    function();
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::resource_unavailable_try_again &&
        error.code() != std::errc::not_enough_memory) {
      throw;
    }
    return false;
  }
}

/// Returns the largest L1 error with which a closure has the status `ok`. The required accuracy is
/// empty if the options of the method set no limit of the error, or if the method is not a closure.
std::optional<double> required_accuracy(const Method& method);

/// Completes the error estimates of all solutions of one problem, such that every solution with the
/// status `ok` has an error estimate. By the triangle inequality, the error estimate from the
/// reference is the L1 distance of a solution from the reference plus the error estimate of the
/// reference.
/// - A closure with a required accuracy but without a residual-based error estimate gets the error
///   estimate from the reference. The status of the closure becomes `inaccurate` if the error
///   estimate from the reference exceeds the required accuracy. If a missing error estimate was the
///   only reason for the status `inaccurate`, and the error estimate from the reference is at most
///   the required accuracy, the status becomes `ok`. Without a reference, a closure with the status
///   `ok` gets its residual-based error estimate.
/// - An external density, or a closure without a required accuracy, gets the error estimate from
///   the reference if the status is `ok` and no error estimate exists. Without a reference, a
///   closure gets its residual-based error estimate, and an external density becomes `inaccurate`.
/// @param methods methods that computed the solutions, in the order of the solutions
/// @param comparison comparison of the solutions; if null, complete_error_estimates() computes the
/// comparison when needed
void complete_error_estimates(const std::vector<Method>& methods,
                              const compare::ComparisonBins& axes,
                              const ResidualErrorEstimator& estimator,
                              std::vector<transform::Solution>& solutions,
                              const compare::SolutionComparison* comparison = nullptr);

}  // namespace fpkcheck::methods
