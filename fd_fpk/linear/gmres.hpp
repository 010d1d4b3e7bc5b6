#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>

#include "base/process/stopwatch.hpp"

namespace fpkcheck::fd_fpk {

/// A linear map A on vectors: the function returns A x.
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;
/// Function that replaces a right-hand side by the approximate solution of a linear system.
using ApproximateLinearSolver = std::function<void(Eigen::Ref<Eigen::VectorXd>)>;

struct GmresResult {
  std::optional<Eigen::VectorXd> solution;
  long iterations = 0;
  std::string failure = {};  ///< reason why GMRES found no solution; empty after a success
};

/// Solves A x = b by GMRES of SUNDIALS (SUNLinSol_SPGMR), with the initial guess x = 0. The
/// preconditioner of GMRES acts from the right, so that the stopping criterion is the residual of
/// the unpreconditioned system.
///
/// @param weights weights w_i of the norm (sum_i (w_i x_i)^2)^(1/2) of a vector x
/// @param tolerance largest accepted relative residual ||A x - b|| / ||b||
/// @throws std::runtime_error if SUNDIALS cannot allocate its memory; also rethrows every exception
/// of `linear_map` and `approximate_solve`
GmresResult solve_by_gmres(const LinearMap& linear_map,
                           const ApproximateLinearSolver& approximate_solve,
                           const Eigen::VectorXd& right_hand_side, const Eigen::VectorXd& weights,
                           double tolerance,
                           const base::Deadline& deadline = base::Deadline::without_time_limit());

}  // namespace fpkcheck::fd_fpk
