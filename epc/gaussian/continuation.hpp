#pragma once

#include "epc/gaussian/projected_equations.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::epc::gaussian {

struct SolutionBranchAndRoot {
  SolutionBranch branch;
  /// Root of the full problem. If the solution branch does not reach fraction 1, the stored root is
  /// the unconverged iterate at the largest fraction.
  numerics::NewtonResult root;
};

/// Follows a branch of solutions of (23) by pseudo-arclength continuation, also past folds. The
/// branch leads from the exact density under white noise with elastic impacts to the full problem
/// (homotopy_coefficients()). If the restoring force has even powers, the solution branch starts
/// from an approximation of the exact density.
SolutionBranchAndRoot follow_solution_branch(const ProjectedEquations& projection,
                                             const DensityEquationCoefficients& full,
                                             double tolerance);

/// Follows Newton's homotopy from a start to a root of the projected equations. If Newton's
/// homotopy does not reach its end, the returned result has not converged.
/// @param start root of the equations of closure order n-2
numerics::NewtonResult follow_newton_homotopy(const ProjectedEquations& projection,
                                              const DensityEquationCoefficients& f,
                                              const Eigen::VectorXd& start, double tolerance);

}  // namespace fpkcheck::epc::gaussian
