#pragma once

#include <Eigen/Core>
#include <functional>

#include "epc/half_plane/galerkin_system.hpp"
#include "numerics/roots/continuation.hpp"
#include "numerics/roots/newton.hpp"
#include "problem/problem.hpp"

/// Norms of residuals and steps, and condition numbers of Jacobians, under the density of the
/// iterate. All of these quantities are independent of the choice of basis.
namespace fpkcheck::epc::half_plane {

/// Unit in which rates of change are measured: the relaxation rate D_eff / E[v^2], which equals the
/// damping c of a linear oscillator, and otherwise the combined effect of damping and impacts. The
/// unit is at least 1e-4 times the frequency: in a smaller unit, the rounding errors of the terms
/// of the undamped motion would dominate the residual.
/// @param temperature approximation of E[v^2]
/// @pre temperature > 0
double rate_of_change_unit(const problem::Problem& problem, double temperature);

/// Norm of a residual R: the supremum of |d E[phi]/dt| / unit over all test polynomials phi of unit
/// variance. This supremum is sqrt(R^T G^{-1} R) / unit, where G is the covariance matrix. The norm
/// is infinite for a singular G.
double residual_norm(const Eigen::VectorXd& residual, const Eigen::MatrixXd& covariance,
                     double unit);

/// Condition number of a Jacobian J in a basis that is orthonormal under the density: ratio of the
/// largest to the smallest singular value of L^{-1} J L^{-T}, where G = L L^T is the covariance
/// matrix.
double condition_number(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& covariance);

/// Norm of a step in the coefficients: the standard deviation of the change of Q_n under the
/// density.
double step_norm(const Eigen::VectorXd& step, const Eigen::MatrixXd& covariance);

/// Solves the Galerkin equations by a damped Newton method. The norm of a step is the standard
/// deviation of the change of Q_n under the density (step_norm). The norm of each step is at most
/// 2, and each step must shorten the next simplified Newton step (Deuflhard's natural monotonicity
/// test). The norm of the residual is residual_norm.
/// @param unit unit in which residuals are measured, see rate_of_change_unit
numerics::NewtonResult solve_by_newton(const GalerkinSystem& equations,
                                       const Eigen::VectorXd& start, double unit,
                                       const numerics::NewtonOptions& options);

/// Follows Newton's homotopy from given coefficients, past folds. The search uses the homotopy if
/// damped Newton steps from the start end at a singular Jacobian. The caller refines the end point
/// of the path by Newton's method.
/// @param should_stop function that is called before each step; the path ends when the function
///        returns true (deadline)
numerics::SolutionCurve follow_homotopy(const GalerkinSystem& equations,
                                        const Eigen::VectorXd& start,
                                        const std::function<bool()>& should_stop = {});

}  // namespace fpkcheck::epc::half_plane
