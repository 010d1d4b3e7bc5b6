#pragma once

#include <Eigen/Core>
#include <string>

#include "fd_fpk/linear/preconditioner.hpp"
#include "fd_fpk/operator/operator.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "fd_fpk/summary.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {

/// Result of time stepping to the stationary density.
struct PseudoTransientResult {
  Eigen::VectorXd averages;  ///< the last density
  std::string reason;        ///< error message of CVODE; empty if CVODE did not stop
  bool out_of_time = false;  ///< whether time stepping stopped because of the deadline
  double residual = 0;  ///< residual of `averages`, FokkerPlanckOperator::stationarity_residual
  long steps = 0;       ///< internal steps of CVODE
  long rhs_evaluations = 0;    ///< number of products L P evaluated for CVODE
  long krylov_iterations = 0;  ///< total iterations of GMRES
  /// time of the integration without factorisations, in seconds; GMRES takes nearly all of this
  /// time
  double krylov_seconds = 0;
};

/// Integrates dP/dt = L P from `start` by SUNDIALS CVODE until ||L P||_1 <= tolerance ||P||_1. The
/// method is BDF of order 1, which is L-stable. BDF of higher order damps slowly near the imaginary
/// axis, where the eigenvalues of the rotating oscillator lie. Local errors do not limit the time
/// steps, which are 10 to 500 decay times long: each time step is a step of inverse iteration,
/// which multiplies the residual by 1/(1 + step/decay time). GMRES solves the linear systems with L
/// itself, to the residual attainable in the step. The preconditioner is KLU, with the factors of
/// the stationary operator if available. The stopping criterion is the residual, not the step size
/// of CVODE. A time step does not start if it would end after the deadline, provided that it takes
/// as long as the preceding step. At the deadline a running time step is aborted.
///
/// @param tolerance tolerance of the residual, per unit time
/// @param decay_time the longest decay time of the problem
/// @throws std::runtime_error when SUNDIALS cannot be set up (no memory)
PseudoTransientResult march_to_stationarity(const FokkerPlanckOperator& op,
                                            Preconditioner& preconditioner,
                                            const Eigen::VectorXd& start, double tolerance,
                                            double decay_time, const Deadline& deadline);

/// The stationary density on the grid and in the box of the options, with its status as in solve().
/// Options::error_estimate and tolerance are ignored: the callers that solve on several grids use
/// these two options. The caller sets the identity of the solution.
Result solve_on_one_grid(const problem::Problem& problem, const ScalesAndBox& scales_and_box,
                         const Options& options, const Deadline& deadline);

/// The stationary density of `kf` with the exact impact on one grid, by the embedded Markov chain
/// of the states after impulses. A step of the chain consists of the transport along
/// characteristics between impulses (characteristics/transport_operator.hpp) and of the velocity
/// jump. For rare impulses the transport dominates, and the transport along characteristics is
/// exact. The density may be unbounded at the origin. Status and options are treated as by
/// solve_on_one_grid.
Result solve_along_characteristics(const problem::Problem& problem,
                                   const problem::MotionScales& scales, const Options& options,
                                   const Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
