#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/linear/preconditioner.hpp"
#include "fd_fpk/operator/fokker_planck_operator.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

struct DirectStationarySolution {
  PlaneDiscretisation discretisation;
  problem::MotionScales scales;
  double refinement = 1;         ///< factor FiniteVolumeOptions::refinement of the solution
  double origin_refinement = 1;  ///< ratio FiniteVolumeOptions::origin_refinement of the solution
  FokkerPlanckOperator op = {};
  std::optional<Preconditioner> preconditioner = {};
  std::optional<Eigen::VectorXd> averages = {};  ///< cell averages of the null vector, with mass 1
  /// Whether GMRES reduced the stationarity residual of the initial density sufficiently
  bool converged = true;
  long krylov_iterations = 0;
  std::string failure = {};  ///< reason why no null vector was found, and what to do
  double krylov_seconds = 0;
};

/// Motion scales and computational box of a problem, which do not depend on the grid.
struct MotionScalesAndComputationalBox {
  problem::MotionScales scales;
  /// Computational box from stationary_box(), computed by compute_direct_solution() if absent
  std::optional<PhasePlaneBox> box = {};
};

/// Returns the computational box for the stationary density. Ends of initial_box() that the options
/// do not fix move outwards until the stationary density at each end, computed on coarse grids, is
/// negligible. For problems without has_linearised_scales(), the returned computational box also
/// contains the length scales of the density.
PhasePlaneBox stationary_box(const problem::Problem& problem, const problem::MotionScales& scales,
                             const FiniteVolumeOptions& options, const base::Deadline& deadline);

/// Computes the stationary density as the null vector of the Fokker-Planck operator, in a
/// computational box at whose ends the density is negligible, on a grid that resolves the density.
/// The solver adapts computational box and grid unless the options fix box and grid. An end of the
/// computational box at which the density exceeds options.wall_density times the peak moves
/// outwards by 15 %, as long as each move decreases the density at that end. After the deadline, an
/// end of the computational box moves only if the density at that end exceeds kMaxBoxEdgeDensity,
/// because a solution with such a density at an end would be rejected. An automatic grid is
/// refined, first at a spike at the origin, while the density violates
/// kAutomaticGridResolutionLimits and the deadline has not passed.
DirectStationarySolution compute_direct_solution(
    const problem::Problem& problem, const MotionScalesAndComputationalBox& scales_and_box,
    const FiniteVolumeOptions& options, const base::Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
