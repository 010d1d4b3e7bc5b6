#pragma once

#include <Eigen/Core>

namespace fpkcheck::fd_fpk {

/// The solution of a x = b by LU with partial pivoting; a file of its own, so that Eigen's LU is
/// compiled once.
Eigen::VectorXd dense_solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd dense_solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace fpkcheck::fd_fpk
