#pragma once

#include <optional>
#include <string>

#include "fd_fpk/linear/linear_map.hpp"
#include "fd_fpk/stopwatch.hpp"

namespace fpkcheck::fd_fpk {

struct GmresResult {
  std::optional<Eigen::VectorXd> solution;
  long iterations = 0;
  std::string failure = {};  ///< reason for the absence of a solution
};

/// Solves A x = b from x = 0 by SUNDIALS' GMRES (SUNLinSol_SPGMR). Preconditioning is from the
/// right, so that the stopping criterion is the true residual.
///
/// @param weights the norm is that of weights times the vector
/// @param tolerance ||A x - b|| / ||b||
/// @param deadline time limit of the iteration
/// @throws std::runtime_error when SUNDIALS cannot be set up (no memory), and every exception of
/// `a` and `approximate_solve`
GmresResult gmres(const LinearMap& a, const ApproximateSolve& approximate_solve,
                  const Eigen::VectorXd& b, const Eigen::VectorXd& weights, double tolerance,
                  const Deadline& deadline = Deadline::none());

}  // namespace fpkcheck::fd_fpk
