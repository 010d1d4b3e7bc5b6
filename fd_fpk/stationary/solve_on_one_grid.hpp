#pragma once

#include <Eigen/Core>
#include <string>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/linear/preconditioner.hpp"
#include "fd_fpk/operator/fokker_planck_operator.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "fd_fpk/summary.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Result of pseudo-transient time steps to the stationary density.
struct PseudoTransientResult {
  Eigen::VectorXd averages;
  std::string reason;        ///< error message of CVODE; empty if CVODE did not stop
  bool out_of_time = false;  ///< whether time stepping stopped because of the deadline
  double residual = 0;       ///< stationarity residual of `averages`, per unit time
  long steps = 0;
  long rhs_evaluations = 0;
  long krylov_iterations = 0;
  /// Computing time of the integration in seconds, without factorisations, nearly all in GMRES
  double krylov_seconds = 0;
};

/// Integrates dP/dt = L P from `initial_averages` by SUNDIALS CVODE until ||L P||_1 <= tolerance
/// ||P||_1. The integration method is BDF of order 1, which is L-stable. BDF of higher order damps
/// slowly near the imaginary axis, where the eigenvalues of the oscillator lie. Each time step, of
/// 500 decay times, is a step of inverse iteration, which multiplies the stationarity residual by
/// 1/(1 + step/decay time). GMRES, preconditioned by KLU factors, solves the linear systems with
/// the operator L itself. A time step does not start if the computing time of the preceding time
/// step exceeds the remaining time before the deadline.
///
/// @param tolerance tolerance of the stationarity residual, per unit time
/// @param decay_time longest decay time of the problem
/// @throws std::runtime_error when SUNDIALS cannot be set up (no memory)
PseudoTransientResult integrate_to_stationarity(const FokkerPlanckOperator& op,
                                                Preconditioner& preconditioner,
                                                const Eigen::VectorXd& initial_averages,
                                                double tolerance, double decay_time,
                                                const base::Deadline& deadline);

/// Computes the stationary density on the grid and in the computational box of the options, with
/// the status codes of solve_stationary_density(). The solver on one grid ignores
/// FiniteVolumeOptions::error_estimate and FiniteVolumeOptions::tolerance, which concern several
/// grids. The caller sets the id of the solution.
FiniteVolumeResult solve_on_one_grid(const problem::Problem& problem,
                                     const MotionScalesAndComputationalBox& scales_and_box,
                                     const FiniteVolumeOptions& options,
                                     const base::Deadline& deadline);

/// Computes the stationary density of the Kolmogorov-Feller equation `kf` with the exact impact
/// condition on one grid, by the embedded Markov chain of the states after impulses. A step of the
/// Markov chain consists of transport along characteristics
/// (characteristics/transport_operator.hpp) and the velocity jump. The stationary density may be
/// unbounded at the origin. Status codes and options have the same meaning as in
/// solve_on_one_grid().
FiniteVolumeResult solve_along_characteristics(const problem::Problem& problem,
                                               const problem::MotionScales& scales,
                                               const FiniteVolumeOptions& options,
                                               const base::Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
