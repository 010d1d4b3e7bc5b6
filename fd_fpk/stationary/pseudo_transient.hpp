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
  long factorisations = 0;     ///< KLU factorisations
  long rhs_evaluations = 0;    ///< products L P asked for by CVODE
  long krylov_iterations = 0;  ///< of GMRES, in all
  double factor_seconds = 0;   ///< in KLU factorisations
  double krylov_seconds = 0;   ///< in all else: GMRES, but for a small rest
};

/// Times that belong to the problem.
struct TimeScales {
  double first_step;
  double longest_step;
};

/// Steps dP/dt = L P from `start` until ||L P||_1 <= tolerance ||P||_1, with SUNDIALS CVODE: BDF of
/// order 1 (L-stable: the eigenvalues of the turning oscillator lie close to the imaginary axis,
/// where higher orders creep), loose local errors, steps that grow by up to 100. The linear systems
/// are solved by GMRES with L itself, preconditioned by one KLU factorisation a step size. Only the
/// residual is judged, never CVODE's step size. No step begins that would end after the deadline if
/// it took as long as the one before; one that does not end by then is given up.
///
/// @param tolerance on the residual, per unit time
/// @throws std::runtime_error when SUNDIALS cannot be set up (no memory)
March march_to_stationarity(const FokkerPlanckOperator& op, Preconditioner& preconditioner,
                            const Eigen::VectorXd& start, double tolerance,
                            const TimeScales& scales, const Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
