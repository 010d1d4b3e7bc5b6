#pragma once

#include <optional>
#include <string>

#include "fd_fpk/linear/linear_map.hpp"

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
/// @throws std::runtime_error when SUNDIALS cannot be set up (no memory), and what `a` and `nearby`
/// throw
GmresResult gmres(const LinearMap& a, const ApproximateSolve& nearby, const Eigen::VectorXd& b,
                  const Eigen::VectorXd& weights, double tolerance);

}  // namespace fpkcheck::fd_fpk
