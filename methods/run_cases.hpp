#pragma once

#include <functional>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "compare/comparison.hpp"
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

/// The `reason` of a solution, or of guaranteed bounds, that could not be computed for lack of
/// memory.
inline constexpr const char* kOutOfMemory =
    "out of memory: the machine or the limit of this process has too little; use coarser grids or "
    "fewer threads";

/// Calls a function, one of the tasks of a run, and catches exceptions due to a lack of memory. The
/// other tasks of the run can then continue, since unwinding the stack frees the memory of this
/// task. The failure to start a thread, whose stack cannot be allocated, is also a lack of memory.
/// @return whether the function returned without a lack of memory
/// @throws any other exception of the function
template <class Function>
bool try_within_memory(const Function& function) {
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

/// The largest L1 error with which a closure has the status `ok`. Empty if the options of the
/// closure set no such limit, and for methods other than closures.
std::optional<double> required_accuracy(const Method& method);

/// Completes the error estimates of all solutions of one problem. Afterwards every solution with
/// the status `ok` has an error estimate. The triangle inequality gives an error estimate from the
/// reference: the L1 distance of a solution from the reference plus the error estimate of the
/// reference.
/// - A closure with a required accuracy lacks an error estimate if the residual method was
///   unsupported, not requested, or gave no result. The closure then gets the error estimate from
///   the reference. If only the missing estimate made the closure `inaccurate`, the status is set
///   back to `ok`. If the new estimate exceeds the required accuracy, the status becomes
///   `inaccurate`. Without a reference, an `ok` closure gets its residual-based error estimate.
/// - Any other `ok` solution without an error estimate (an external density, a closure without a
///   required accuracy) gets the error estimate from the reference. Without a reference, a closure
///   gets its residual-based error estimate, and any other solution becomes `inaccurate`.
/// @param methods methods that computed the solutions, in the same order
/// @param comparison the comparison of the solutions, if already computed; else null
void complete_error_estimates(const std::vector<Method>& methods,
                              const compare::ComparisonAxes& axes,
                              const ResidualErrorEstimator& estimator,
                              std::vector<transform::Solution>& solutions,
                              const compare::Comparison* comparison = nullptr);

}  // namespace fpkcheck::methods
