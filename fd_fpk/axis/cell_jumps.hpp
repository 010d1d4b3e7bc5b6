#pragma once

#include <Eigen/Core>

#include "fd_fpk/axis/axis.hpp"

namespace fpkcheck::problem {
class ImpulseLaw;
}  // namespace fpkcheck::problem

namespace fpkcheck::fd_fpk {

/// The effect of an impulse on the masses of velocity cells, column by column. Unlike jump_matrix
/// this operator does not interpolate across cells, so that a spike remains a positive mass.
struct CellJumps {
  /// From a cell with uniformly distributed mass, shape (cells, cells): columns sum to 1. Mass that
  /// would leave the axis is kept in the cell at its end.
  Eigen::MatrixXd uniform;
  /// The contribution of a slope of 1, i.e. of the mass distribution (v - centre) dv / width;
  /// columns sum to 0.
  Eigen::MatrixXd slope;
};

CellJumps cell_jumps(const Axis& axis, const problem::ImpulseLaw& law);

}  // namespace fpkcheck::fd_fpk
