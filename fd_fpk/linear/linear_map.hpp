#pragma once

#include <Eigen/Core>
#include <functional>

namespace fpkcheck::fd_fpk {

/// A linear map on vectors: returns A x.
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;
/// Replaces a vector by the solution of an approximate system.
using ApproximateSolve = std::function<void(Eigen::Ref<Eigen::VectorXd>)>;

}  // namespace fpkcheck::fd_fpk
