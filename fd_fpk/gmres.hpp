#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>

namespace fpkcheck::fd_fpk {

/// A linear map on vectors: writes A x.
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;
/// Replaces a vector by the solution of a nearby system.
using ApproximateSolve = std::function<void(Eigen::Ref<Eigen::VectorXd>)>;

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
/// @throws std::runtime_error when SUNDIALS cannot be set up (no memory)
GmresResult gmres(const LinearMap& a, const ApproximateSolve& nearby, const Eigen::VectorXd& b,
                  const Eigen::VectorXd& weights, double tolerance);

}  // namespace fpkcheck::fd_fpk
