#pragma once

#include <Eigen/Core>

#include "fd_fpk/axis/axis.hpp"

namespace fpkcheck::problem {
class ImpulseLaw;
}  // namespace fpkcheck::problem

namespace fpkcheck::fd_fpk {

/// Matrices that map the masses of velocity cells before an impulse to the masses after the
/// impulse. Unlike jump_matrix, these matrices do not interpolate across cells, so that a spike of
/// the density in a cell remains a positive mass.
struct CellJumpMatrices {
  /// Matrix for cells with uniformly distributed mass, shape (cells, cells). Every column sums to
  /// 1. Mass that would leave the axis remains in the outermost cell.
  Eigen::MatrixXd uniform;
  /// Matrix for a slope of 1, that is for the mass distribution (v - centre) dv / width in a cell.
  /// Every column sums to 0.
  Eigen::MatrixXd slope;
};

CellJumpMatrices cell_jump_matrices(const Axis& axis, const problem::ImpulseLaw& law);

}  // namespace fpkcheck::fd_fpk
