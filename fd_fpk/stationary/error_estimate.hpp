#pragma once

#include <functional>

#include "fd_fpk/options.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "fd_fpk/summary.hpp"

namespace fpkcheck::fd_fpk {

/// The estimated discretisation error of the finest of three solutions, by Richardson extrapolation
/// (transform::richardson). The cells of each grid are narrower than those of the preceding grid by
/// transform::kRefinementRatio. Solutions on successive grids are compared on the cells of the
/// finer grid. The discretisation error is estimated, not bounded: the largest observed ratio of
/// error to estimate is 2.5.
/// @param order the order of accuracy of the scheme
/// @pre all three solutions have a density
ErrorEstimate estimate_error(const Result& coarse, const Result& middle, const Result& fine,
                             int order);

/// Function that solves one problem with the given options on a single grid.
using SolveOnOneGrid = std::function<Result(const Options&)>;

/// Returns the solution on the grid of the options, with an error estimate. The error estimate uses
/// direct solutions on two coarser grids, whose cells are wider by transform::kRefinementRatio and
/// by its square. The solution includes the extrapolated moments if transform::has_richardson_limit
/// accepts the observed order of convergence.
Result solve_with_error_estimate(const SolveOnOneGrid& solve, const Options& options);

/// Goal of refine_until_deadline().
struct RefinementGoal {
  double accuracy = kTargetAccuracy;
  /// whether the grid is refined also if the error is small but the status is not `ok`
  bool until_ok = false;
};

/// Returns the solution with an error estimate, computed as in solve_with_error_estimate. The grid
/// is refined while the error estimate exceeds the accuracy of the goal. A finer grid is tried only
/// if its expected time is at most a fraction of the time limit, or if the status of the solution
/// is not yet `ok`. A solve that exceeds the deadline is aborted.
Result refine_until_deadline(const SolveOnOneGrid& solve, const Options& options,
                             const Deadline& deadline, const RefinementGoal& goal);

/// Whether the first result is preferable to the second result. The first criterion that differs
/// decides, in this order: the status is `ok`; there is an error estimate; there is a density; the
/// error estimate is smaller.
bool is_better(const Result& first, const Result& second);

/// The solution on the first grid of a sequence whose error estimate is below options.tolerance.
/// The cells of each grid are narrower than those of the preceding grid by
/// transform::kRefinementRatio. The error estimate comprises the L1 errors of the marginal
/// densities of y and y', and the relative errors of the second moments. If the differences between
/// successive solutions decrease more slowly than the order of the scheme predicts, the cells are
/// graded towards the origin. The status is `not_converged` if the error estimate on the largest
/// permitted grid still exceeds the tolerance; the deadline and the maximum number of cells limit
/// the size of the grid. The solution includes extrapolated moments under the condition of
/// solve_with_error_estimate.
Result solve_to_tolerance(const SolveOnOneGrid& solve, const Options& options,
                          const Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
