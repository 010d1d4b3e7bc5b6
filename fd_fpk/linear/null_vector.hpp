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
  long iterations = 0;       ///< iterations of GMRES
  std::string failure = {};  ///< reason why there are no averages; empty if there are averages
  double krylov_seconds = 0;
};

/// The stationary density without time steps: the null vector of L with mass 1, start + d. The
/// vector `start` has mass 1, and GMRES solves L d = -L start for the correction d, with a
/// preconditioner of one factorisation. L conserves mass, so that all residuals and d have mass 0:
/// the singular system is consistent at every step.
/// @param deadline time limit of the GMRES iteration
NullVector null_vector(const FokkerPlanckOperator& op, Preconditioner& preconditioner,
                       const Eigen::VectorXd& start,
                       const Deadline& deadline = Deadline::unlimited());

/// The null vector with mass 1 by inverse iteration with KLU factors of the whole matrix L. For
/// unstable operators, which no simple preconditioner approximates. A solver that does not test
/// well-posedness would return this vector as its density.
/// @param frequency frequency of the oscillator, the unit of residuals
NullVector null_vector_by_inverse_iteration(const FokkerPlanckOperator& op,
                                            const Eigen::VectorXd& start, double frequency);

}  // namespace fpkcheck::fd_fpk
