#include "fd_fpk/axis/dense_solve.hpp"

#include <Eigen/LU>

namespace fpkcheck::fd_fpk {

Eigen::VectorXd dense_solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.partialPivLu().solve(b);
}

Eigen::MatrixXd dense_solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.partialPivLu().solve(b);
}

}  // namespace fpkcheck::fd_fpk
