#pragma once

#include <Eigen/Core>
#include <functional>

namespace fpkcheck::fd_fpk {

/// A linear map A on vectors: the function returns A x.
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;
/// Function that replaces a right-hand side by the approximate solution of a linear system.
using ApproximateSolve = std::function<void(Eigen::Ref<Eigen::VectorXd>)>;

}  // namespace fpkcheck::fd_fpk
