#pragma once

#include <functional>
#include <string>
#include <vector>

#include "methods/method.hpp"
#include "methods/problem_residuals.hpp"
#include "problem/problem.hpp"
#include "results/run.hpp"

namespace fpkcheck::methods {

/// Where a run stands.
struct RunProgress {
  std::size_t done;   ///< solutions finished
  std::size_t total;  ///< solutions asked for
  std::string case_name;
  std::string method;
  double fraction;        ///< of this method's work: 1 when it has just finished
  std::string note = {};  ///< what else the method has to say; may be empty
};

/// Told of progress; called from several threads, never two at once.
using ProgressListener = std::function<void(const RunProgress&)>;

/// Solves a problem by a method on the axes of its case; the solution knows who it is and what was
/// asked for. Where memory does not suffice it has failed for that reason. Of a density equation or a
/// simulation it is not `ok` without a stated error; of others complete_errors() sees to that.
transform::Solution solve_by(const Method& method, const problem::Problem& problem,
                             const Setting& setting);

/// @throws InputError when a method cannot be asked to solve one of the problems (Method::check)
void require_solvable(const std::vector<problem::Problem>& problems,
                      const std::vector<Method>& methods);

/// Solves every problem by every method and compares, if all can be asked to (require_solvable).
/// Methods that use one processor run side by side; those that use all of them run alone.
/// @param methods by increasing trust
/// @param threads processors to use; 0 for all
/// @throws whatever a solver throws, after the others have ended
std::vector<results::Case> run_cases(const std::vector<problem::Problem>& problems,
                                     const std::vector<Method>& methods, int threads,
                                     const ProgressListener& listener);

/// Told of a case as soon as it has all its solutions; called from several threads.
using CaseListener = std::function<void(const results::Case&)>;

/// The same with residuals that the caller keeps, one for each problem.
/// @param case_listener if there is one, nothing more is begun when the program is told to stop
///                      (base/process/stop.hpp), and what is returned may lack the last cases
std::vector<results::Case> run_cases(const std::vector<problem::Problem>& problems,
                                     const std::vector<Method>& methods, int threads,
                                     const ProgressListener& listener,
                                     const std::vector<ProblemResiduals>& residuals,
                                     const CaseListener& case_listener);

}  // namespace fpkcheck::methods
