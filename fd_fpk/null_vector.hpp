#pragma once

#include <Eigen/Core>
#include <optional>

#include "fd_fpk/grid.hpp"
#include "fd_fpk/operator.hpp"

namespace fpkcheck::fd_fpk {

/// ||L P||_1 / ||P||_1: the rate, per unit time, at which a density is not stationary.
double stationarity_residual(const SparseColumns& matrix, const Eigen::VectorXd& averages);

/// The stationary density without stepping: the null vector of L by inverse iteration with one
/// factorisation of L - shift I, normalised to mass 1. Empty when KLU finds the matrix singular or
/// the vector is not finite.
///
/// No row is replaced by the normalisation: a dense row would ruin the ordering.
std::optional<Eigen::VectorXd> null_vector(const SparseColumns& matrix, const Grid& grid,
                                           const Eigen::VectorXd& start);

}  // namespace fpkcheck::fd_fpk
