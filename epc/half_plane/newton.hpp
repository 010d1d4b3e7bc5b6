#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>

#include "epc/half_plane/galerkin_system.hpp"
#include "numerics/roots/continuation.hpp"
#include "numerics/roots/newton.hpp"
#include "problem/problem.hpp"

/// Newton's method for the Galerkin equations of a closure. The norms of residuals and steps, and
/// the condition number, do not depend on the choice of basis functions.
namespace fpkcheck::epc::half_plane {

/// Returns the unit of rates of change of moments: the relaxation rate D_eff / E[v^2] with the
/// noise coefficient D_eff, but at least 1e-4 times the frequency. For a linear oscillator the
/// relaxation rate D_eff / E[v^2] is the damping c. In a smaller unit than 1e-4 of the frequency,
/// rounding errors of the terms of the undamped motion would dominate the residual.
/// @param temperature approximate value of E[v^2]
/// @pre temperature > 0
double relaxation_rate_unit(const problem::Problem& problem, double temperature);

/// Returns the norm of a residual of the moment equations: the supremum of |d E[phi]/dt| / unit
/// over all polynomials phi of variance 1. The norm of a residual R equals sqrt(R^T G^{-1} R) /
/// unit with the covariance matrix G of the basis functions, and is infinite for a singular G.
double residual_norm(const Eigen::VectorXd& residual, const Eigen::MatrixXd& covariance,
                     double unit);

/// Returns the condition number of a Jacobian J in an orthonormal basis: ratio of largest to
/// smallest singular value of L^{-1} J L^{-T}, where G = L L^T is the covariance matrix of the
/// basis functions.
double condition_number(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& covariance);

/// Returns the eigenvalue with the largest real part of J G^-1, where J is the Jacobian of the
/// moment equations and G the covariance matrix of the basis functions. Near a root of the moment
/// equations, deviations dm of the moments follow d(dm)/dt = J G^-1 dm, with the Jacobian J and the
/// covariance matrix G. A root at which the moment equations have an eigenvalue with a positive
/// real part is unstable: almost all nearby closure densities move away from the root. The negative
/// real part of the rightmost eigenvalue of the linearised moment equations is the relaxation rate
/// of the closure.
std::complex<double> rightmost_eigenvalue(const Eigen::MatrixXd& jacobian,
                                          const Eigen::MatrixXd& covariance);

/// Returns the standard deviation of the change of the exponent Q_n by a step in its coefficients.
double step_norm(const Eigen::VectorXd& step, const Eigen::MatrixXd& covariance);

/// Solves the Galerkin equations of a closure by a damped Newton method. The norm of each Newton
/// step is at most 2, and each step must shorten the next simplified Newton step (Deuflhard's
/// natural monotonicity test).
numerics::NewtonResult solve_by_newton(const GalerkinSystem& equations,
                                       const Eigen::VectorXd& start, double unit,
                                       const numerics::NewtonOptions& options);

/// Follows Newton's homotopy from given coefficients of Q_n towards a root, also past folds. The
/// end point of the homotopy path needs a refinement by Newton's method.
/// @param should_stop called before each step; the path ends when this function returns true
numerics::SolutionCurve follow_homotopy(const GalerkinSystem& equations,
                                        const Eigen::VectorXd& start,
                                        const std::function<bool()>& should_stop = {});

}  // namespace fpkcheck::epc::half_plane
