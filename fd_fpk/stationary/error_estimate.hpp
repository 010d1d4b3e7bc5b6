#pragma once

#include <functional>
#include <optional>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/summary.hpp"

namespace fpkcheck::fd_fpk {

/// Returns the estimated discretisation error of the finest of three solutions, by Richardson
/// extrapolation (transform/richardson.hpp). The cell widths of successive grids differ by the
/// factor transform::kRefinementRatio. The discretisation error is estimated, not bounded: the
/// largest observed ratio of the true error to the estimated error is 2.5.
/// @pre all three solutions have a density
DiscretisationErrorEstimate estimate_error_from_three_grids(const FiniteVolumeResult& coarse,
                                                            const FiniteVolumeResult& middle,
                                                            const FiniteVolumeResult& fine,
                                                            int order);

/// Returns the options for a grid with cell widths divided by `factor`, without automatic
/// refinement.
FiniteVolumeOptions with_refined_cells(FiniteVolumeOptions options, double factor);

/// Function that solves one problem with the given options on a single grid. The function must be
/// thread-safe.
using SolveOnOneGrid = std::function<FiniteVolumeResult(const FiniteVolumeOptions&)>;

/// Returns the solution on the grid that the options specify, with an error estimate from direct
/// solutions on two coarser grids. The cells of the two coarser grids are wider than the cells of
/// the finest grid by the factors q and q^2, with q = transform::kRefinementRatio. The solution
/// includes extrapolated moments if transform::has_richardson_limit accepts the observed order of
/// convergence.
/// @param known_box computational box that `solve` uses unless its ends must be moved outwards. If
/// the computational box is known, the solutions on the three grids are computed in parallel.
FiniteVolumeResult solve_with_error_estimate(const SolveOnOneGrid& solve,
                                             const FiniteVolumeOptions& options,
                                             const std::optional<PhasePlaneBox>& known_box = {});

/// Condition under which automatic refinement of the grid stops.
enum class GridRefinementGoal {
  accurate,  ///< the L1 error estimate is at most kAutomaticGridTargetL1Error
  /// Refinement stops at an L1 error estimate <= kAutomaticGridTargetL1Error and the status `ok`.
  accurate_and_ok
};

/// Returns the solution with an error estimate, on a grid that is refined until the given
/// refinement goal is reached. The solver tries a finer grid only if the expected computing time is
/// at most a fraction of the time limit, or if the status of the solution is not yet `ok`.
FiniteVolumeResult refine_grid_until_deadline(const SolveOnOneGrid& solve,
                                              const FiniteVolumeOptions& options,
                                              const base::Deadline& deadline,
                                              GridRefinementGoal goal,
                                              const std::optional<PhasePlaneBox>& known_box = {});

/// Returns whether the result `first` is preferable to the result `second`. The preferable result
/// is determined by the first criterion in which the two results differ: status `ok`, existence of
/// an error estimate, existence of a density, smaller error estimate.
bool is_preferable_result(const FiniteVolumeResult& first, const FiniteVolumeResult& second);

/// Returns the solution on the first grid of a sequence whose error estimate is below
/// options.tolerance. If the observed order of convergence is well below the order of the scheme,
/// the cells are graded towards the origin. The status of the solution is `not_converged` if the
/// error estimate on the largest permitted grid still exceeds the tolerance.
FiniteVolumeResult refine_grid_to_tolerance(const SolveOnOneGrid& solve,
                                            const FiniteVolumeOptions& options,
                                            const base::Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
