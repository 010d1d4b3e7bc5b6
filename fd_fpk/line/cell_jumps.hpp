#pragma once

#include <Eigen/Core>

#include "fd_fpk/line/line.hpp"

namespace fpkcheck::problem {
class ImpulseLaw;
}  // namespace fpkcheck::problem

namespace fpkcheck::fd_fpk {

/// What an impulse does to masses on the cells of a velocity line, column by column. Unlike
/// jump_matrix nothing is interpolated across cells, so that a spike stays a positive mass.
struct CellJumps {
  /// From a cell in which the mass is evenly spread, shape (cells, cells): its columns sum to 1.
  /// What would leave the line stays in the cell at its end.
  Eigen::MatrixXd even;
  /// What a tilt of 1 adds, the mass 1 (v - centre) dv / width; its columns sum to 0.
  Eigen::MatrixXd tilt;
};

CellJumps cell_jumps(const Line& line, const problem::ImpulseLaw& law);

}  // namespace fpkcheck::fd_fpk
