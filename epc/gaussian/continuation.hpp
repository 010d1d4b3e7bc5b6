#pragma once

#include "epc/gaussian/projected_equations.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::epc::gaussian {

/// A branch of solutions, and the root of the full problem at the end of the branch.
struct BranchAndRoot {
  SolutionBranch branch;
  /// Root of the full problem. If the branch does not reach fraction 1, this member is the iterate
  /// at the largest fraction instead, and has not converged.
  numerics::NewtonResult root;
};

/// Follows a branch of solutions of (23) with homotopy_coefficients() by pseudo-arclength
/// continuation, which passes folds. The branch leads from the exact density under white noise with
/// elastic impacts to the full problem. If the spring force has even powers, the exponent of the
/// exact density is not a polynomial, and the branch starts from an approximation of this density.
BranchAndRoot follow_solution_branch(const ProjectedEquations& projection,
                                     const ResidualCoefficients& full, double tolerance);

/// Follows Newton's homotopy to a root of the equations.
/// @param start root of the equations of lower order
numerics::NewtonResult follow_newton_homotopy(const ProjectedEquations& projection,
                                              const ResidualCoefficients& f,
                                              const Eigen::VectorXd& start, double tolerance);

}  // namespace fpkcheck::epc::gaussian
