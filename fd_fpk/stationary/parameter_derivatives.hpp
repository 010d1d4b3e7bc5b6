#pragma once

#include <Eigen/Core>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/linear/gmres.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "problem/parameter_derivative.hpp"
#include "problem/problem.hpp"

/// Derivative of the stationary density with respect to a parameter, on the grid of a stationary
/// solution. With the derivative dL of the generator on this grid, the derivative dp of the density
/// p satisfies L dp = -dL p, int dp = 0.
namespace fpkcheck::fd_fpk {

/// Returns the cell averages of dL p, by a difference quotient of the generator on the same grid.
/// @param problem problem in wall coordinates
/// @pre the solution has cell averages
Eigen::VectorXd generator_derivative_product(const problem::Problem& problem,
                                             const FiniteVolumeOptions& options,
                                             const problem::ParameterDifferenceQuotient& parameter,
                                             const DirectStationarySolution& stationary);

/// Solves L dp = -dL p with mass 0 of dp.
/// @param generator_derivative cell averages of dL p
/// @param approximate_solve preconditioner of L, up to a factor
GmresResult solve_density_derivative(const DirectStationarySolution& stationary,
                                     const Eigen::VectorXd& generator_derivative,
                                     const ApproximateLinearSolver& approximate_solve,
                                     const base::Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
