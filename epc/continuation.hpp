#pragma once

#include "epc/branch.hpp"
#include "epc/newton.hpp"

namespace fpkcheck::epc {

/// The branch, and the root where it reaches the full problem.
struct FollowedBranch {
  Branch branch;
  NewtonResult root;  ///< converged only if it does; else at the greatest fraction
};

/// Follows the solution of (23) by pseudo-arclength along the path of `partway`, from the exact
/// density of white noise at an impact without loss towards the full problem, past folds.
FollowedBranch follow_branch(const Projection& projection, const ResidualCoefficients& full,
                             double tolerance);

/// Adds equations little by little: follows R(a) = (1 - t) R(start) from the start, a root of the
/// equations of lower order, to a root of all at t = 1 (Newton's homotopy).
NewtonResult add_equations(const Projection& projection, const ResidualCoefficients& f,
                           const Eigen::VectorXd& start, double tolerance);

}  // namespace fpkcheck::epc
