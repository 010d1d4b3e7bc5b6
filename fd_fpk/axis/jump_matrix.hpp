#pragma once

#include <Eigen/Core>

#include "fd_fpk/axis/axis.hpp"

namespace fpkcheck::problem {
class ImpulseLaw;
}  // namespace fpkcheck::problem

/// Velocity jumps as matrices on cell averages of a velocity axis, shape (cells, cells). The
/// cumulative distribution of p is interpolated with polynomials of degree 7 and shifted: moments 0
/// to 6 after the jump are exact where p is smooth. Jumps that would leave the axis are omitted.
namespace fpkcheck::fd_fpk {

/// The matrix of a jump by a fixed amplitude, p(x2 - amplitude) - p(x2), for jumps that end on the
/// axis.
Eigen::MatrixXd shift_matrix(const Axis& axis, double amplitude);

/// The matrix of the jump by a random amplitude Y, E[p(x2 - Y)] - p(x2): the jump integral of paper
/// (15) before its expansion, for any law and any axis. Gauss-Legendre panels integrate the product
/// of the law's density and the interpolation.
Eigen::MatrixXd jump_matrix(const Axis& axis, const problem::ImpulseLaw& law);

}  // namespace fpkcheck::fd_fpk
