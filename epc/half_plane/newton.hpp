#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>

#include "epc/half_plane/galerkin_system.hpp"
#include "numerics/roots/continuation.hpp"
#include "numerics/roots/newton.hpp"
#include "problem/problem.hpp"

/// Newton's method for the Galerkin equations. The norms of residuals and steps, and the condition
/// number, do not depend on the choice of basis.
namespace fpkcheck::epc::half_plane {

/// Returns the unit of rates of change: the relaxation rate D_eff / E[v^2], but at least 1e-4 times
/// the frequency. For a linear oscillator the relaxation rate is the damping c. If the unit were
/// smaller than this minimum, rounding errors of the terms of the undamped motion would dominate
/// the residual.
/// @param temperature approximation of E[v^2]
/// @pre temperature > 0
double relaxation_rate_unit(const problem::Problem& problem, double temperature);

/// Returns the norm of a residual R: the supremum of |d E[phi]/dt| / unit over all polynomials phi
/// of unit variance. The norm equals sqrt(R^T G^{-1} R) / unit with the covariance matrix G, and is
/// infinite for a singular G.
double residual_norm(const Eigen::VectorXd& residual, const Eigen::MatrixXd& covariance,
                     double unit);

/// Returns the condition number of a Jacobian J in a basis that is orthonormal under the density:
/// ratio of the largest to the smallest singular value of L^{-1} J L^{-T}, where G = L L^T is the
/// covariance matrix.
double condition_number(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& covariance);

/// Returns the eigenvalue of J G^-1 with the largest real part, where J is the Jacobian and G the
/// covariance matrix. Near a root the moments m = E[phi] of a density of the closure follow
/// d(dm)/dt = J G^-1 dm. A root whose rightmost eigenvalue has a positive real part is unstable:
/// almost all densities of the closure near this root move away from the root. The negative real
/// part of the rightmost eigenvalue is the relaxation rate of the closure.
std::complex<double> rightmost_eigenvalue(const Eigen::MatrixXd& jacobian,
                                          const Eigen::MatrixXd& covariance);

/// Returns the standard deviation of the change of the exponent Q_n by a step in the coefficients
/// of the polynomial Q_n.
double step_norm(const Eigen::VectorXd& step, const Eigen::MatrixXd& covariance);

/// Solves the Galerkin equations by a damped Newton method. The norm of each Newton step is at most
/// 2, and each step must shorten the next simplified Newton step (Deuflhard's natural monotonicity
/// test).
numerics::NewtonResult solve_by_newton(const GalerkinSystem& equations,
                                       const Eigen::VectorXd& start, double unit,
                                       const numerics::NewtonOptions& options);

/// Follows Newton's homotopy from given coefficients, also past folds. The end point of the
/// homotopy path still needs a refinement by Newton's method.
/// @param should_stop is called before each step; the path ends when this function returns true
numerics::SolutionCurve follow_homotopy(const GalerkinSystem& equations,
                                        const Eigen::VectorXd& start,
                                        const std::function<bool()>& should_stop = {});

}  // namespace fpkcheck::epc::half_plane
