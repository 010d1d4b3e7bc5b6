#pragma once

#include <Eigen/Core>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/linear/gmres.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "problem/parameter_derivative.hpp"
#include "problem/problem.hpp"

/// Derivative of the stationary density with respect to a parameter, on the grid of a stationary
/// solution. With the discretised generator L and its parameter derivative dL, the derivative dp of
/// the stationary density p satisfies L dp = -dL p, int dp = 0.
namespace fpkcheck::fd_fpk {

/// Returns the cell averages of dL p, the derivative of the generator applied to the density, by a
/// difference quotient of the generator on the same grid.
/// @param problem problem in wall coordinates
/// @pre the solution has cell averages
Eigen::VectorXd generator_derivative_product(const problem::Problem& problem,
                                             const FiniteVolumeOptions& options,
                                             const problem::ParameterDifferenceQuotient& parameter,
                                             const DirectStationarySolution& stationary);

/// Solves the equation L dp = -dL p for the derivative dp of the density, with the mass 0 of dp.
/// @param generator_derivative cell averages of dL p, from generator_derivative_product()
/// @param approximate_solve preconditioner of the generator L, up to a factor
GmresResult solve_density_derivative(const DirectStationarySolution& stationary,
                                     const Eigen::VectorXd& generator_derivative,
                                     const ApproximateLinearSolver& approximate_solve,
                                     const base::Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
