#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fd_fpk/grid.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::fd_fpk {

/// What to integrate, and how accurately. Times in the units of the problem.
struct TransientOptions {
  double until = 0;    ///< T > 0
  int snapshots = 50;  ///< N: densities are kept at t = 0, T/N, .. T
  /// Deviations of z and z' in the Gaussian to start from, of mean zero; automatic: half of those
  /// of equivalent linearisation.
  std::optional<double> start_displacement{};
  std::optional<double> start_velocity{};
  /// Local error of a step, relative to the largest density.
  double relative_tolerance = 1e-6;
  /// Highest order of BDF, 1 .. 5. Only up to 2 is it stable on the whole imaginary axis, close to
  /// which the eigenvalues of the turning oscillator lie.
  int max_order = 2;
  /// Told the fraction of the time that is done; may be empty.
  std::function<void(double)> progress{};
};

/// @throws InputError on the first option that cannot be used for a density over time
void validate(const Options& options, const TransientOptions& transient);

/// The density at one time.
struct Snapshot {
  double time = 0;
  transform::Moments moments{};
  double energy = 0;  ///< E[v^2]/2 + k E[y^2]/2 + mu E[y^4]/4
  double power = 0;   ///< input minus dissipation, problem::power: dE/dt if all is right
  /// What `power` differs by from the dE/dt of dp/dt = L p, relative to lambda E[Y^2]/2: an error
  /// of the grid alone.
  double power_residual = 0;
  double impact_rate = 0;  ///< int_{v<0} |v| p(0, v) dv
  double mass = 0;
  double min_density = 0;   ///< relative to the largest
  WallDensity wall{0, 0};   ///< as relative_wall_density
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
  std::vector<double> y_edges;  ///< the grid's own
  std::vector<double> v_edges;
  std::vector<Snapshot> snapshots;   ///< as far as it went
  long steps = 0;                    ///< of CVODE
  long factorisations = 0;           ///< by KLU
  long rhs_evaluations = 0;          ///< products L P asked for by CVODE
  long krylov_iterations = 0;        ///< of GMRES, in all
  double regularisation_length = 0;  ///< l of km4, else 0
};

/// p(y, y', t) by the operator of solve() from a Gaussian in the (z, z') plane, which, as its mean
/// is zero, is point symmetric: on y >= 0 the density starts as twice it. Time is stepped by CVODE:
/// BDF of variable step and order, GMRES preconditioned by KLU.
///
/// What the options leave free of box and grid is made to hold and to resolve both the stationary
/// density and the start with all that its energy can turn into. Options::stepper,
/// residual_tolerance are not used. Options::order must be 3 or 5: other operators have growing
/// modes.
///
/// Status: `ok`; `ill_posed` as solve(); `not_converged` when CVODE stopped on the way;
/// `inadmissible` when the density at some snapshot is negative or misses the balance of power by
/// more than a resolved one would; `failed` when the box is too small or the grid would be too
/// large.
/// @throws InputError when the options cannot be used
TransientResult integrate(const problem::Problem& problem, const Options& options,
                          const TransientOptions& transient);

}  // namespace fpkcheck::fd_fpk
