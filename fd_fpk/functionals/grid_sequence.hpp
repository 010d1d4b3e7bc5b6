#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Values of functionals, computed on a sequence of grids.
struct FunctionalValuesFromGridSequence {
  Eigen::VectorXd values = {};  ///< values on the finest grid; empty without a solution
  Eigen::VectorXd errors = {};  ///< estimated discretisation errors of the values
  /// Absolute difference of the values on the last two grids, and on the two grids before the last
  /// grid; the latter is empty for two grids
  Eigen::VectorXd last_difference = {}, previous_difference = {};
  int nx = 0, nv = 0;        ///< numbers of cells of the finest grid
  bool reached = false;      ///< whether all errors are within the tolerance
  std::string failure = {};  ///< reason why there are no values, or why the tolerance is missed
};

/// Returns error estimates from the absolute differences between the last three grids, by
/// transform::errors_with_common_order(). If `previous_difference` is empty, the error estimates
/// follow from the last two grids, with the order 1.
/// @param order order of the scheme
Eigen::VectorXd error_estimates(const Eigen::VectorXd& previous_difference,
                                const Eigen::VectorXd& last_difference,
                                const Eigen::VectorXd& scales, int order);

/// Values on one grid.
struct FunctionalValuesOnGrid {
  Eigen::VectorXd values = {};
  int nx = 0, nv = 0;
  std::string failure = {};  ///< reason why `values` is empty
};

/// Function that returns the magnitudes of values, to which the tolerance is relative.
using MagnitudeFunction = std::function<Eigen::VectorXd(const Eigen::VectorXd& values)>;

/// Computes functionals on a sequence of grids. The cells of each grid are narrower than the cells
/// of the preceding grid by the factor transform::kRefinementRatio. The sequence has at least three
/// grids if the time limit permits. The errors follow from the differences between the last three
/// grids, as in transform/richardson.hpp. The first two grids are solved in parallel.
/// @param evaluate_on_grid function that computes the values on the grid with automatic cells
/// divided by `refinement`; two threads may call the function at the same time
/// @param order order of the scheme
/// @param tolerance relative error at which no finer grid is tried
FunctionalValuesFromGridSequence refine_grids_until_converged(
    const std::function<FunctionalValuesOnGrid(double refinement)>& evaluate_on_grid, int order,
    double tolerance, const MagnitudeFunction& magnitudes, const base::Deadline& deadline);

/// Function that computes the values from the stationary solution on one grid. If the returned
/// vector is empty, the function has stored a reason in `failure`.
using StationaryFunctionals =
    std::function<Eigen::VectorXd(DirectStationarySolution& direct_solution,
                                  const base::Deadline& deadline, std::string& failure)>;

/// Computes functionals of the generator and of the stationary density by
/// refine_grids_until_converged().
/// @pre unsupported_reason() and transient_unsupported_reason() are empty
FunctionalValuesFromGridSequence refine_grids_until_converged(
    const problem::Problem& problem, const FiniteVolumeOptions& options, double tolerance,
    const StationaryFunctionals& functionals, const MagnitudeFunction& magnitudes);

}  // namespace fpkcheck::fd_fpk
