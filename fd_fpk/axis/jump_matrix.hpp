#pragma once

#include <Eigen/Core>

#include "fd_fpk/axis/axis.hpp"

namespace fpkcheck::problem {
class ImpulseLaw;
}  // namespace fpkcheck::problem

/// Velocity jumps as matrices on cell averages of a velocity axis, shape (cells, cells). The
/// cumulative of p is interpolated with degree 7 and shifted: moments 0 .. 6 after the jump are
/// exact wherever p is smooth. Jumps that would leave the axis do not take place.
namespace fpkcheck::fd_fpk {

/// p(x2 - amplitude) - p(x2), for jumps that end on the axis.
Eigen::MatrixXd shift_matrix(const Axis& axis, double amplitude);

/// E[p(x2 - Y)] - p(x2): the jump integral of paper (15) before its expansion, for any law and any
/// axis. Gauss-Legendre panels integrate the law's density against the interpolation.
Eigen::MatrixXd jump_matrix(const Axis& axis, const problem::ImpulseLaw& law);

}  // namespace fpkcheck::fd_fpk
