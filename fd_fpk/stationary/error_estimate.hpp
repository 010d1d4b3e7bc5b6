#pragma once

#include <functional>

#include "fd_fpk/options.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "fd_fpk/summary.hpp"

namespace fpkcheck::fd_fpk {

/// The discretisation error of the last of three solutions on grids refined by
/// transform::kRefinementRatio, by transform::richardson; neighbouring levels are compared on the cells
/// of the finer grid. An estimate, not a bound: it has been low by up to a factor of 2.5.
/// @param order of the scheme
/// @pre all three solutions have a density
ErrorEstimate estimate_error(const Result& coarse, const Result& middle, const Result& fine,
                             int order);

/// Solves a fixed problem with the given options on a single grid.
using SolveOnOneGrid = std::function<Result(const Options&)>;

/// The solution on the grid of the options with an error estimate from two grids with cells wider
/// by transform::kRefinementRatio and its square (direct solves). The solution includes its
/// extrapolation where transform::has_limit accepts the observed order.
Result solve_with_error_estimate(const SolveOnOneGrid& solve, const Options& options);

/// Target of the automatic grid for the error in L1, where time permits.
inline constexpr double kTargetAccuracy = 1e-4;

/// Goal of refine_until_deadline().
struct RefinementGoal {
  double accuracy = kTargetAccuracy;
  bool until_ok = false;  ///< refine also where the error is small and the status not `ok`
};

/// As solve_with_error_estimate, with finer grids while the estimate exceeds the accuracy of the
/// goal. A finer grid needs an expected time of at most a fraction of the limit, or a solution that
/// is not yet `ok`. A solve that exceeds the deadline is aborted.
Result refine_until_deadline(const SolveOnOneGrid& solve, const Options& options,
                             const Deadline& deadline, const RefinementGoal& goal);

/// True if the first result is preferable: `ok` before not `ok`, with before without an error
/// estimate, with before without a density, then by the smaller estimate.
bool is_better(const Result& first, const Result& second);

/// The solution on the first of a sequence of grids, each with cells narrower by
/// transform::kRefinementRatio, whose error estimate is below options.tolerance: L1 of both marginals,
/// and the second moments relative. If the differences fall more slowly than the order of the
/// scheme predicts, cells are graded towards the origin. Status `not_converged` when the largest
/// grid permitted by the deadline or the number of cells misses the tolerance. The solution
/// includes its extrapolation as above.
Result solve_to_tolerance(const SolveOnOneGrid& solve, const Options& options,
                          const Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
