#pragma once

#include <Eigen/Core>

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

/// Residuals, steps and Jacobians measured under the density that they belong to, so that no number
/// depends on the basis.
namespace fpkcheck::epc::half_plane {

/// The measure of rates of change: the damping c, but at least 1e-4 of the linearised frequency,
/// below which the rates of the motion itself leave no digits.
double rate_unit(const problem::Problem& problem);

/// sup over the test polynomials of unit variance of |d E[phi]/dt| / unit, which does not depend on
/// the basis: sqrt(R^T G^{-1} R) / unit with the covariance G. Infinite where G is singular.
double size_of(const Eigen::VectorXd& residual, const Eigen::MatrixXd& covariance, double unit);

/// Condition of a Jacobian in functions that are orthonormal under the density: the ratio of the
/// extreme singular values of L^{-1} J L^{-T}, where G = L L^T.
double condition_of(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& covariance);

/// Length of a step in the coefficients: the standard deviation of the change of Q_n.
double length(const Eigen::VectorXd& step, const Eigen::MatrixXd& covariance);

}  // namespace fpkcheck::epc::half_plane
