#pragma once

#include <Eigen/Core>

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

/// Norms of residuals, steps and Jacobians under their density. All are independent of the basis.
namespace fpkcheck::epc::half_plane {

/// Unit of rates of change: the damping c, but at least 1e-4 of the linearised frequency. For
/// smaller damping the rounding errors of the terms of the undamped motion would dominate the
/// residual.
double rate_unit(const problem::Problem& problem);

/// Norm of a residual: sup of |d E[phi]/dt| / unit over the test polynomials of unit variance,
/// which is sqrt(R^T G^{-1} R) / unit with the covariance G. Infinite for a singular G.
double residual_norm(const Eigen::VectorXd& residual, const Eigen::MatrixXd& covariance,
                     double unit);

/// Condition number of a Jacobian in functions orthonormal under the density: ratio of the extreme
/// singular values of L^{-1} J L^{-T}, where G = L L^T is the covariance.
double condition_number(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& covariance);

/// Norm of a step in the coefficients: standard deviation of the change of Q_n.
double step_norm(const Eigen::VectorXd& step, const Eigen::MatrixXd& covariance);

}  // namespace fpkcheck::epc::half_plane
