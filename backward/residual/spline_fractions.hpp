#pragma once

#include <Eigen/Core>
#include <span>

#include "numerics/splines/quintic_bsplines.hpp"

namespace fpkcheck::backward {

/// Fraction of the integral of each spline that lies in each cell.
/// @param edges increasing
/// @return shape (cells, functions); columns sum to 1 where the cells cover the splines
/// @throws InputError when the edges do not increase
Eigen::MatrixXd spline_fractions(const numerics::QuinticBSplines& splines,
                                 std::span<const double> edges);

}  // namespace fpkcheck::backward
