#pragma once

#include <Eigen/Dense>

#include "epc/moment/galerkin.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::moment {

struct NewtonOptions {
  double tolerance = 1e-10;  ///< on the residual's size, see size_of
  int max_iterations = 60;
  bool polish = false;  ///< one step more after convergence, which takes the root to rounding
};

/// How an iteration ended; not reaching a root is a result.
struct NewtonResult {
  Eigen::VectorXd a;    ///< the root, or the iterate of the smallest residual
  double residual = 0;  ///< its size
  int iterations = 0;
  bool converged = false;
};

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

/// Newton's method, damped by what is measured, as all else here, by the standard deviation of the
/// change of Q_n under the density: no step changes it by more than 2, and each must shorten the
/// next simplified step (Deuflhard's natural monotonicity test).
/// @param unit rate_unit
NewtonResult newton(const Galerkin& equations, const Eigen::VectorXd& start, double unit,
                    const NewtonOptions& options);

}  // namespace fpkcheck::epc::moment
