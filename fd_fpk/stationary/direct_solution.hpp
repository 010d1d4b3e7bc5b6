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

/// A discrete operator, its grid and its null vector.
struct DirectSolution {
  Discretisation discretisation;
  problem::MotionScales scales;
  double refinement = 1;         ///< the factor Options::refinement that was used
  double origin_refinement = 1;  ///< the ratio Options::origin_refinement that was used
  FokkerPlanckOperator op = {};
  std::optional<Preconditioner> preconditioner = {};
  std::optional<Eigen::VectorXd> averages = {};  ///< the null vector, with mass 1
  bool converged = true;       ///< whether CVODE can start from the averages, by the residual
  long krylov_iterations = 0;  ///< number of GMRES iterations on the final grid
  std::string failure = {};    ///< reason why there is no null vector, and what to do
  double krylov_seconds = 0;   ///< time of GMRES on the final grid
};

/// Properties of a problem that do not depend on its grid.
struct ScalesAndBox {
  problem::MotionScales scales;
  /// The result of stationary_box(). If the box is absent, solve_directly() computes the box.
  std::optional<Box> box = {};
};

/// The box for the stationary density. The solver moves the ends of initial_box() that the options
/// leave free outwards until the stationary density at these ends, computed on coarse grids, is
/// negligible. After the deadline an end of the box moves only if the density at this end exceeds
/// kMaxWallDensity. For problems without has_linearised_scales(), the result also contains the
/// length scales of the density.
Box stationary_box(const problem::Problem& problem, const problem::MotionScales& scales,
                   const Options& options, const Deadline& deadline);

/// The direct solution in a box at whose ends the density is negligible, on a grid that resolves
/// the density. The solver adapts box and grid as far as the options leave box and grid free:
/// - An end of the box with a density above options.wall_density times the peak moves outwards by
///   15 %, as long as each move decreases the density at the end. The densities for the first moves
///   are computed on coarse grids. After the deadline an end moves only if the density at this end
///   exceeds kMaxWallDensity, because the solution would otherwise be rejected.
/// - An automatic grid is refined (first at a spike at the origin) while the density violates
///   kAutomaticGridLimits and the deadline has not passed. A solve that exceeds the deadline is
///   aborted.
DirectSolution solve_directly(const problem::Problem& problem, const ScalesAndBox& scales_and_box,
                              const Options& options, const Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
