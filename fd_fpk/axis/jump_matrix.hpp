#pragma once

#include <Eigen/Core>

#include "fd_fpk/axis/grid.hpp"

namespace fpkcheck::problem {
class ImpulseLaw;
}  // namespace fpkcheck::problem

/// Velocity jumps as matrices on cell averages of a velocity axis, shape (cells, cells). The
/// cumulative distribution of the density p is interpolated with polynomials of degree 7 and
/// shifted by the amplitude: the moments of order 0 to 6 after the jump are exact where p is
/// smooth. Jumps that would end outside the axis are omitted.
namespace fpkcheck::fd_fpk {

/// The matrix of a jump by a fixed amplitude, p(x2 - amplitude) - p(x2), for jumps that end on the
/// axis.
Eigen::MatrixXd shift_matrix(const Axis& axis, double amplitude);

/// The matrix of the jump by a random amplitude Y, E[p(x2 - Y)] - p(x2): the jump integral of paper
/// (15) before its expansion, for any law and any axis. Gauss-Legendre panels integrate the product
/// of the law's density and the interpolation.
Eigen::MatrixXd jump_matrix(const Axis& axis, const problem::ImpulseLaw& law);

/// Matrices that map the masses of velocity cells before an impulse to the masses after the
/// impulse. Unlike jump_matrix, the cell jump matrices do not interpolate across cells, so that a
/// spike of the density in a cell remains a positive mass.
struct CellJumpMatrices {
  /// Matrix for cells with uniformly distributed mass, shape (cells, cells). Every column sums to
  /// 1. Mass that an impulse would move outside the axis remains in the outermost cell.
  Eigen::MatrixXd uniform;
  /// Matrix for a slope of 1, that is for the mass distribution (v - centre) dv / width in a cell.
  /// Every column sums to 0.
  Eigen::MatrixXd slope;
};

CellJumpMatrices cell_jump_matrices(const Axis& axis, const problem::ImpulseLaw& law);

}  // namespace fpkcheck::fd_fpk
