#pragma once

#include <string>
#include <vector>

#include "fd_fpk/operator/wall_density.hpp"
#include "fd_fpk/transient_options.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::fd_fpk {

/// The density at one time, in physical coordinates.
struct Snapshot {
  double time = 0;
  transform::Moments moments{};
  double yv = 0;      ///< E[y y']
  double energy = 0;  ///< E[v^2]/2 + E[U(y)], U the spring's potential
  double power = 0;   ///< input minus dissipation, problem::power: dE/dt if all is right
  /// What `power` differs by from the dE/dt of dp/dt = L p, relative to D + lambda E[Y^2]/2: an
  /// error of the grid alone.
  double power_residual = 0;
  double impact_rate = 0;  ///< int |v| p dv into the walls
  double mass = 0;
  double min_density = 0;   ///< relative to the largest
  WallDensity wall{0, 0};   ///< as relative_wall_density, of the problem in its frame
  std::vector<double> y{};  ///< p(y, t), averages over the cells between TransientResult::y_edges
  std::vector<double> v{};  ///< p(y', t), likewise
};

/// A density over time, and how it came about.
struct TransientResult {
  transform::Status status = transform::Status::failed;
  std::string reason;             ///< one sentence; never empty unless the status is ok
  double seconds = 0;             ///< wall-clock time
  double start_displacement = 0;  ///< deviations as used
  double start_velocity = 0;
  double start_mean_displacement = 0;  ///< the middle of the start as used
  double start_mean_velocity = 0;
  std::vector<double> y_edges;  ///< the grid's own
  std::vector<double> v_edges;
  std::vector<Snapshot> snapshots;   ///< as far as it went
  long steps = 0;                    ///< of CVODE
  long factorisations = 0;           ///< by KLU
  long rhs_evaluations = 0;          ///< products L P asked for by CVODE
  long krylov_iterations = 0;        ///< of GMRES, in all
  double regularisation_length = 0;  ///< l of km4, else 0
};

/// p(y, y', t) by the operator of solve() from a Gaussian that is cut off at the walls and has mass
/// 1 between them: from one of mean zero in the (z, z') plane, where the wall is at y = 0. Time is
/// stepped by CVODE: BDF of variable step and order, GMRES preconditioned by KLU.
///
/// What the options leave free of box and grid is made to hold and to resolve both the stationary
/// density and the start with all that its energy can turn into, as far as 10 000 cells do. Options::stepper,
/// residual_tolerance are not used. Options::order must be 3 or 5: other operators have growing
/// modes.
///
/// Status: `ok`; `ill_posed` as solve(); `not_converged` when CVODE stopped on the way;
/// `inadmissible` when the density at some snapshot exceeds kBarsOverTime; `failed` when the box is
/// too small or the grid would be too large.
/// @param problem in any coordinates: it is solved in its frame, and what comes out is physical
/// @throws InputError when the options cannot be used, and as objection_over_time says
TransientResult integrate(const problem::Problem& problem, const Options& options,
                          const TransientOptions& transient);

}  // namespace fpkcheck::fd_fpk
