#pragma once

#include <Eigen/Core>

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

/// Norms of residuals and steps, and condition numbers of Jacobians, under the density of the
/// iterate. All of these quantities are independent of the choice of basis.
namespace fpkcheck::epc::half_plane {

/// Unit in which rates of change are measured: the damping c, but at least 1e-4 times the frequency
/// of equivalent linearisation. In a smaller unit, the rounding errors of the terms of the undamped
/// motion would dominate the residual.
double rate_of_change_unit(const problem::Problem& problem);

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

}  // namespace fpkcheck::epc::half_plane
