#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::fd_fpk {

/// Density of displacement and velocity at one time, in physical coordinates.
struct DensitySnapshot {
  double time = 0;
  transform::Moments moments{};
  double yv = 0;      ///< moment E[y y']
  double energy = 0;  ///< mean energy E[v^2]/2 + E[U(y)], with the potential U of the spring
  /// Power input minus dissipated power (problem::power_balance); equal to the rate of change dE/dt
  /// of the mean energy for the exact equation
  double power = 0;
  /// Difference between the balance of power (`power`) and the rate of change dE/dt of the mean
  /// energy in the discrete equation dp/dt = L p, relative to the input power D + lambda E[Y^2]/2.
  /// Without discretisation error the power residual is 0.
  double power_residual = 0;
  double impact_rate = 0;  ///< flux of probability into the walls, int |v| p dv
  double mass = 0;
  double min_density = 0;     ///< smallest density, relative to the largest density
  BoxEdgeDensity wall{0, 0};  ///< density on the edges of the box, relative to the peak
  std::vector<double> y{};    ///< p(y, t), averages over the cells between TransientResult::y_edges
  std::vector<double> v{};  ///< p(y', t), averages over the cells between TransientResult::v_edges
};

/// Cell averages of p(y, y') in the coordinates of the grid, in the order of FokkerPlanckOperator.
struct CellAveragedDensity {
  std::vector<double> x1_faces, x2_faces;
  Eigen::VectorXd averages;
};

struct TransientResult {
  transform::Status status = transform::Status::failed;
  std::string reason;  ///< reason for the status; empty only for the status ok
  double seconds = 0;
  double start_displacement = 0;  ///< standard deviation of y in the initial density
  double start_velocity = 0;
  double start_mean_displacement = 0;  ///< mean of y in the initial density
  double start_mean_velocity = 0;
  std::vector<double> y_edges;  ///< faces of the grid in y
  std::vector<double> v_edges;
  std::vector<DensitySnapshot> snapshots;  ///< snapshots up to the end of the integration
  long steps = 0;
  long factorisations = 0;
  long rhs_evaluations = 0;
  long krylov_iterations = 0;
  /// density at t = 0 of the periodic state under a periodic excitation
  std::optional<CellAveragedDensity> periodic_state = {};
  int periods = 0;  ///< number of periods to the periodic state; 0 without a periodic state
  double change_over_period = 0;  ///< L1 change of the density over a period of the periodic state
  /// Estimated L1 distance of the density to the periodic state, from change_over_period and the
  /// decay rate of the slowest mode
  double distance_to_periodic_state = 0;
  double regularisation_length = 0;  ///< regularisation length l of km4; 0 for other equations
};

/// Computes the density p(y, y', t) over time with the Fokker-Planck operator of the stationary
/// density. The initial density is a Gaussian, truncated at the walls and normalised to mass 1
/// between the walls. CVODE integrates in time by backward differentiation formulas (BDF) of
/// variable step and order, with GMRES preconditioned by KLU.
///
/// An automatic computational box contains the stationary density, the initial density, and every
/// state that the initial energy can reach. An automatic grid resolves the stationary and the
/// initial density, as far as a maximum of 10 000 cells permits. The options
/// FiniteVolumeOptions::stepper and residual_tolerance do not affect the density over time.
/// FiniteVolumeOptions::order must be 3 or 5, since operators of other orders have growing modes.
///
/// The periodic state is the fixed point of the map from the density at t = 0 to the density one
/// period later, found by numerics::solve_fixed_point(). The status of the periodic state is
/// `not_converged` if the estimated L1 distance to the periodic state exceeds 1e-4.
///
/// The status of the density over time is `inadmissible` if the density at an output time violates
/// kTransientResolutionLimits.
/// @param problem problem in any coordinates; the result has physical coordinates
/// @throws InputError for invalid options, or if transient_unsupported_reason is not empty
TransientResult solve_transient(const problem::Problem& problem, const FiniteVolumeOptions& options,
                                const TransientOptions& transient);

}  // namespace fpkcheck::fd_fpk
