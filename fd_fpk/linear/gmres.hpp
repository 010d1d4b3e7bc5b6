#pragma once

#include <optional>
#include <string>

#include "fd_fpk/linear/linear_map.hpp"
#include "fd_fpk/stopwatch.hpp"

namespace fpkcheck::fd_fpk {

struct GmresResult {
  std::optional<Eigen::VectorXd> solution;
  long iterations = 0;
  std::string failure = {};  ///< why there is no solution
};

/// Solves A x = b from x = 0 by SUNDIALS' GMRES (SUNLinSol_SPGMR), preconditioned from the right,
/// so that the true residual is what is judged.
///
/// @param weights the norm is that of weights times the vector
/// @param tolerance ||A x - b|| / ||b||
/// @param deadline at which it gives up
/// @throws std::runtime_error when SUNDIALS cannot be set up (no memory), and what `a` and `nearby`
/// throw
GmresResult gmres(const LinearMap& a, const ApproximateSolve& nearby, const Eigen::VectorXd& b,
                  const Eigen::VectorXd& weights, double tolerance,
                  const Deadline& deadline = Deadline::none());

}  // namespace fpkcheck::fd_fpk
