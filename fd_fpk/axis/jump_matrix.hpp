#pragma once

#include <Eigen/Core>

#include "fd_fpk/axis/grid.hpp"

namespace fpkcheck::problem {
class ImpulseLaw;
}  // namespace fpkcheck::problem

/// Velocity jumps as matrices on the cell averages of a velocity axis, shape (cells, cells).
/// Polynomials of degree 7 interpolate the cumulative distribution of the density p. The velocity
/// moments of order 0 to 6 after an impulse are exact where the density is smooth. Velocity jumps
/// to outside the axis are omitted.
namespace fpkcheck::fd_fpk {

/// Returns the matrix of a velocity jump by a fixed amplitude, p(x2 - amplitude) - p(x2).
Eigen::MatrixXd jump_matrix_of_fixed_amplitude(const GridAxis& axis, double amplitude);

/// Returns the matrix of a velocity jump by a random amplitude Y, E[p(x2 - Y)] - p(x2). The matrix
/// discretises the jump integral of paper (15) before the expansion of the integral, for any law.
/// Gauss-Legendre panels integrate the product of the law's density and the interpolation.
Eigen::MatrixXd jump_matrix(const GridAxis& axis, const problem::ImpulseLaw& law);

/// Matrices that map the masses of velocity cells before an impulse to the masses of the cells
/// after the impulse. Without interpolation across cells, a spike of the density in a cell remains
/// a positive mass.
struct CellJumpMatrices {
  /// Jump matrix for mass that is uniform in each velocity cell, shape (cells, cells); every column
  /// sums to 1. Mass that an impulse would move outside the axis remains in the outermost cell.
  Eigen::MatrixXd uniform;
  /// Jump matrix for mass with the density (v - centre) / width in each velocity cell; every column
  /// sums to 0.
  Eigen::MatrixXd slope;
};

CellJumpMatrices cell_jump_matrices(const GridAxis& axis, const problem::ImpulseLaw& law);

}  // namespace fpkcheck::fd_fpk
