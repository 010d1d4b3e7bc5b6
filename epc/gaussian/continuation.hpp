#pragma once

#include "epc/gaussian/projected_equations.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::epc::gaussian {

struct SolutionBranchAndRoot {
  SolutionBranch branch;
  /// Root of the full problem. If the solution branch does not reach the full problem (fraction 1),
  /// the stored root is the last iterate at the largest fraction, and has not converged.
  numerics::NewtonResult root;
};

/// Follows a branch of solutions of equation (23) of the paper by pseudo-arclength continuation,
/// also past folds. The branch of solutions leads from the exact density under white noise with
/// elastic impacts to the full problem (homotopy_coefficients()). If the restoring force has even
/// powers, the branch of solutions starts from an approximate density.
SolutionBranchAndRoot follow_solution_branch(const ProjectedEquations& projection,
                                             const DensityEquationCoefficients& full,
                                             double tolerance);

/// Follows Newton's homotopy from given coefficients of Q_n to a root of the projected equations
/// (23) of the paper. If Newton's homotopy does not reach its end, the result has not converged.
/// @param start root of the equations of closure order n-2
numerics::NewtonResult follow_newton_homotopy(const ProjectedEquations& projection,
                                              const DensityEquationCoefficients& f,
                                              const Eigen::VectorXd& start, double tolerance);

}  // namespace fpkcheck::epc::gaussian
