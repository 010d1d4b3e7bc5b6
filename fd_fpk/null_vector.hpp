#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "fd_fpk/grid.hpp"
#include "fd_fpk/operator.hpp"

namespace fpkcheck::fd_fpk {

/// ||L P||_1 / ||P||_1: the rate, per unit time, at which a density is not stationary.
double stationarity_residual(const SparseColumns& matrix, const Eigen::VectorXd& averages);

struct NullVector {
  std::optional<Eigen::VectorXd> averages;
  std::string failure;  ///< why there are none
};

/// The stationary density without stepping: the null vector of L by inverse iteration with one
/// factorisation of L - shift I, normalised to mass 1.
///
/// No row is replaced by the normalisation: a dense row would ruin the ordering.
/// @param slowest_decay rate of the slowest mode, problem::slowest_decay: sets the shift
NullVector null_vector(const SparseColumns& matrix, const Grid& grid, const Eigen::VectorXd& start,
                       double slowest_decay);

}  // namespace fpkcheck::fd_fpk
