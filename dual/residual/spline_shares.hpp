#pragma once

#include <Eigen/Core>
#include <span>

#include "dual/spline/knot_splines.hpp"

namespace fpkcheck::dual {

/// The part of each spline's integral, between the ends of all, that lies in each cell.
/// @param edges increasing
/// @return shape (cells, functions); columns sum to 1 where the cells cover the splines
/// @throws InputError when the edges do not increase
Eigen::MatrixXd spline_shares(const KnotSplines& splines, std::span<const double> edges);

}  // namespace fpkcheck::dual
