#pragma once

#include <Eigen/Core>

namespace fpkcheck::fd_fpk {

/// The solution x of the dense system a x = b, by LU factorisation with partial pivoting. The
/// function has a file of its own, so that Eigen's LU is compiled only once.
Eigen::VectorXd dense_solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd dense_solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace fpkcheck::fd_fpk
