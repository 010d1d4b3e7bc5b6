#pragma once

#include "epc/gaussian/newton.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::epc::gaussian {

/// The branch, and the root where it reaches the full problem.
struct FollowedBranch {
  Branch branch;
  numerics::NewtonResult root;  ///< converged only if it does; else at the greatest fraction
};

/// Follows the solution of (23) by pseudo-arclength along the path of `partway`, from the exact
/// density of white noise at an impact without loss towards the full problem, past folds. (For a
/// spring with even powers that density is no polynomial: from the nearest that is.)
FollowedBranch follow_branch(const Projection& projection, const ResidualCoefficients& full,
                             double tolerance);

/// Adds equations little by little: follows Newton's homotopy from the start, a root of the
/// equations of lower order, to a root of all.
numerics::NewtonResult add_equations(const Projection& projection, const ResidualCoefficients& f,
                                     const Eigen::VectorXd& start, double tolerance);

}  // namespace fpkcheck::epc::gaussian
