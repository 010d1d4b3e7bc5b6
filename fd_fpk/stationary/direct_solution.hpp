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

/// An operator on its grid with its null vector.
struct DirectSolution {
  Discretisation discretisation;
  problem::Scales scales;
  double refinement = 1;         ///< as used
  double origin_refinement = 1;  ///< as used
  FokkerPlanckOperator op = {};
  std::optional<Preconditioner> preconditioner = {};
  std::optional<Eigen::VectorXd> averages = {};  ///< mass 1
  bool converged = true;                         ///< GMRES did, to what is worth going on from
  long krylov_iterations = 0;                    ///< of GMRES, on the final grid
  std::string failure = {};                      ///< why there are no averages, and what to do
  double krylov_seconds = 0;                     ///< of GMRES, on the final grid
};

/// What of a problem does not depend on its grid.
struct Surroundings {
  problem::Scales scales;
  /// stationary_box, where it was found before; else solve_directly looks for it.
  std::optional<Box> box = {};
};

/// initial_box with those walls that the options leave free moved out on coarse grids until the
/// stationary density on them is negligible; after the deadline, until it is below kMostOnWall.
/// Beyond the paper's class with the lengths of that density.
Box stationary_box(const problem::Problem& problem, const Options& options,
                   const Deadline& deadline);
Box stationary_box(const problem::Problem& problem, const problem::Scales& scales,
                   const Options& options, const Deadline& deadline);

/// The direct solution in a box whose walls carry no density, on a grid that resolves it, as far as
/// the options leave box and grid free:
/// - a wall with more than options.wall_density of the peak moves out by 15 % as long as the
///   density on it falls, first on coarse grids; after the deadline only where it is above
///   kMostOnWall, with which there would be no answer;
/// - an automatic grid is refined, at a spike at the origin first, while the density exceeds
///   kAutomaticGridBars and the time lasts; what is not there at the deadline is given up.
DirectSolution solve_directly(const problem::Problem& problem, const Surroundings& surroundings,
                              const Options& options, const Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
