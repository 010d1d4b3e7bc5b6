#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "fd_fpk/linear/preconditioner.hpp"
#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/operator/operator.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// An operator on its grid and its null vector.
struct DirectSolution {
  Discretisation discretisation;
  problem::Scales scales;
  double refinement = 1;         ///< refinement as used
  double origin_refinement = 1;  ///< origin refinement as used
  FokkerPlanckOperator op = {};
  std::optional<Preconditioner> preconditioner = {};
  std::optional<Eigen::VectorXd> averages = {};  ///< the null vector, with mass 1
  bool converged = true;       ///< true if GMRES reduced the residual enough for further steps
  long krylov_iterations = 0;  ///< iterations of GMRES on the final grid
  std::string failure = {};    ///< reason for the absence of averages, and what to do
  double krylov_seconds = 0;   ///< time of GMRES on the final grid
};

/// Properties of a problem that do not depend on its grid.
struct ScalesAndBox {
  problem::Scales scales;
  /// stationary_box, if already known; else solve_directly computes it.
  std::optional<Box> box = {};
};

/// initial_box with the walls that the options leave free moved outwards, on coarse grids, until
/// the stationary density on them is negligible; at the deadline, until it is below
/// kMaxWallDensity. Outside the paper's class with the length scales of that density.
Box stationary_box(const problem::Problem& problem, const Options& options,
                   const Deadline& deadline);
Box stationary_box(const problem::Problem& problem, const problem::Scales& scales,
                   const Options& options, const Deadline& deadline);

/// The direct solution in a box with a negligible density on its walls, on a grid that resolves the
/// density, as far as the options leave box and grid free:
/// - A wall with more than options.wall_density of the peak moves out by 15 % as long as the
///   density on it falls, first on coarse grids. At the deadline it moves only if the density is
///   above kMaxWallDensity, which would reject the solution.
/// - An automatic grid is refined (first at a spike at the origin) while the density violates
///   kAutomaticGridLimits and time remains. A solve that exceeds the deadline is aborted.
DirectSolution solve_directly(const problem::Problem& problem, const ScalesAndBox& scales_and_box,
                              const Options& options, const Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
