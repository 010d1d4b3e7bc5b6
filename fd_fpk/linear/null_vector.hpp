#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "fd_fpk/linear/preconditioner.hpp"
#include "fd_fpk/operator/operator.hpp"
#include "fd_fpk/stopwatch.hpp"

namespace fpkcheck::fd_fpk {

struct NullVector {
  std::optional<Eigen::VectorXd> averages;
  long iterations = 0;       ///< of GMRES
  std::string failure = {};  ///< why there are no averages
  double krylov_seconds = 0;
};

/// The stationary density without stepping: the null vector of L of mass 1. The correction d of a
/// start of mass 1 solves L d = -L start by GMRES with one factorisation of the preconditioner. All
/// residuals, and so d, have no mass: the singular system is consistent at every step.
/// @param deadline at which GMRES gives up
NullVector null_vector(const FokkerPlanckOperator& op, Preconditioner& preconditioner,
                       const Eigen::VectorXd& start, const Deadline& deadline = Deadline::none());

/// The null vector of mass 1 by inverse iteration with KLU factors of the whole of L, for operators
/// that nothing simple approximates: those that grow. It is what a solver would return that does
/// not ask whether the equation is well-posed.
/// @param frequency of the oscillator: the unit in which a residual is small
NullVector factored_null_vector(const FokkerPlanckOperator& op, const Eigen::VectorXd& start,
                                double frequency);

}  // namespace fpkcheck::fd_fpk
