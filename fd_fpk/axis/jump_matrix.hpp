#pragma once

#include <Eigen/Core>

#include "fd_fpk/axis/grid.hpp"

namespace fpkcheck::problem {
class ImpulseLaw;
}  // namespace fpkcheck::problem

/// Velocity jumps as matrices on the cell averages of a velocity axis, shape (cells, cells).
/// Polynomials of degree 7 interpolate the cumulative distribution of the density p. The velocity
/// moments of order 0 to 6 after an impulse are exact where the density is smooth. Velocity jumps
/// to velocities outside the axis are omitted.
namespace fpkcheck::fd_fpk {

/// Returns the matrix of p(x2 - amplitude) - p(x2) for a velocity jump by a fixed amplitude.
Eigen::MatrixXd jump_matrix_of_fixed_amplitude(const GridAxis& axis, double amplitude);

/// Returns the matrix of the jump integral E[p(x2 - Y)] - p(x2) for a velocity jump by a random
/// amplitude Y. The matrix discretises the jump integral before the series expansion of paper (15),
/// for any law of the impulse amplitude. Gauss-Legendre panels integrate the product of the
/// probability density of the amplitude and the interpolated density p.
Eigen::MatrixXd jump_matrix(const GridAxis& axis, const problem::ImpulseLaw& law);

/// Matrices that map the masses of velocity cells before an impulse to the masses of the cells
/// after the impulse. The cell masses are not interpolated across cells, so that a spike of the
/// density remains a positive mass.
struct CellJumpMatrices {
  /// Jump matrix, shape (cells, cells), for mass that is uniformly distributed in each velocity
  /// cell; the sum of every column is 1. Mass that an impulse would move outside the axis remains
  /// in the outermost cell.
  Eigen::MatrixXd uniform;
  /// Jump matrix for the linear density (v - centre) / width in each velocity cell, with the
  /// velocity v; the sum of every column is 0.
  Eigen::MatrixXd slope;
};

CellJumpMatrices cell_jump_matrices(const GridAxis& axis, const problem::ImpulseLaw& law);

}  // namespace fpkcheck::fd_fpk
