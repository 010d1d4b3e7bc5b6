#pragma once

#include <Eigen/Core>

#include "fd_fpk/line/line.hpp"

namespace fpkcheck::problem {
class ImpulseLaw;
}  // namespace fpkcheck::problem

/// Jumps of the velocity as matrices on cell averages of a velocity line, shape (cells, cells). The
/// cumulative of p is interpolated with degree 7 and moved: the moments 0 .. 6 of what arrives are
/// exact wherever p is smooth. What would leave the line stays where it is.
namespace fpkcheck::fd_fpk {

/// p(x2 - amplitude) - p(x2), for jumps that stay on the line.
Eigen::MatrixXd shift_matrix(const Line& line, double amplitude);

/// E[p(x2 - Y)] - p(x2): the jump integral of paper (15) before it is expanded, for any law and any
/// line; the law's density is integrated by Gauss-Legendre panels against the interpolation.
Eigen::MatrixXd jump_matrix(const Line& line, const problem::ImpulseLaw& law);

}  // namespace fpkcheck::fd_fpk
