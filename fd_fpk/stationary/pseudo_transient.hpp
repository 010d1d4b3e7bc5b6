#pragma once

#include <Eigen/Core>
#include <string>

#include "fd_fpk/linear/preconditioner.hpp"
#include "fd_fpk/operator/operator.hpp"
#include "fd_fpk/stopwatch.hpp"

namespace fpkcheck::fd_fpk {

/// How the march to stationarity went.
struct March {
  Eigen::VectorXd averages;    ///< the last density reached
  std::string reason;          ///< why CVODE stopped, in its own words; empty when it did not
  bool out_of_time = false;    ///< the next step would have ended after the deadline
  double residual = 0;         ///< FokkerPlanckOperator::residual of `averages`
  long steps = 0;              ///< CVODE's internal steps
  long rhs_evaluations = 0;    ///< products L P asked for by CVODE
  long krylov_iterations = 0;  ///< of GMRES, in all
  double krylov_seconds = 0;   ///< but for factorisations: in GMRES, but for a small rest
};

/// Steps dP/dt = L P from `start` until ||L P||_1 <= tolerance ||P||_1, with SUNDIALS CVODE: BDF of
/// order 1 (L-stable: the eigenvalues of the turning oscillator lie close to the imaginary axis,
/// where higher orders creep), steps of 10 to 500 decay times that no local error shortens: each is
/// one of inverse iteration, and leaves 1/(1 + step/decay time) of the residual. The linear systems
/// are solved by GMRES with L itself as far as the residual that a step may reach asks for,
/// preconditioned by KLU: by the factors of the stationary operator where they are at hand. Only the
/// residual is judged, never CVODE's step size. No step begins that would end after the deadline if
/// it took as long as the one before; one that does not end by then is given up.
///
/// @param tolerance on the residual, per unit time
/// @param decay_time the longest of the problem
/// @throws std::runtime_error when SUNDIALS cannot be set up (no memory)
March march_to_stationarity(const FokkerPlanckOperator& op, Preconditioner& preconditioner,
                            const Eigen::VectorXd& start, double tolerance, double decay_time,
                            const Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
