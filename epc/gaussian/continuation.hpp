#pragma once

#include "epc/gaussian/newton.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::epc::gaussian {

/// Branch of solutions, and the root at the full problem.
struct FollowedBranch {
  Branch branch;
  /// Converged if the branch reaches the full problem; else the iterate at the largest fraction.
  numerics::NewtonResult root;
};

/// Follows the solution of (23) with homotopy_coefficients by pseudo-arclength, past folds. The
/// branch starts from the exact density under white noise with elastic impacts, towards the full
/// problem. For a spring with even powers the exponent of that density is no polynomial, and the
/// branch starts from an approximation.
FollowedBranch follow_branch(const Projection& projection, const ResidualCoefficients& full,
                             double tolerance);

/// Follows Newton's homotopy from a root of the equations of lower order to a root of all
/// equations.
numerics::NewtonResult follow_newton_homotopy(const Projection& projection,
                                              const ResidualCoefficients& f,
                                              const Eigen::VectorXd& start, double tolerance);

}  // namespace fpkcheck::epc::gaussian
