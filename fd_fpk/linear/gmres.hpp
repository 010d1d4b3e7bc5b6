#pragma once

#include <optional>
#include <string>

#include "fd_fpk/linear/linear_map.hpp"
#include "fd_fpk/stopwatch.hpp"

namespace fpkcheck::fd_fpk {

struct GmresResult {
  std::optional<Eigen::VectorXd> solution;
  long iterations = 0;
  std::string failure = {};  ///< reason why there is no solution; empty if there is a solution
};

/// Solves A x = b from x = 0 by SUNDIALS' GMRES (SUNLinSol_SPGMR). The preconditioner acts from the
/// right, so that the stopping criterion is the residual of A x = b itself.
///
/// @param weights weights of the norm: the norm of a vector is the 2-norm of the products of
/// weights and entries
/// @param tolerance largest accepted ||A x - b|| / ||b||
/// @param deadline time limit of the iteration
/// @throws std::runtime_error when SUNDIALS cannot be set up (no memory), and every exception of
/// `a` and `approximate_solve`
GmresResult gmres(const LinearMap& a, const ApproximateSolve& approximate_solve,
                  const Eigen::VectorXd& b, const Eigen::VectorXd& weights, double tolerance,
                  const Deadline& deadline = Deadline::unlimited());

}  // namespace fpkcheck::fd_fpk
