#pragma once

#include <Eigen/SparseCore>
#include <span>

namespace fpkcheck::backward {

using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Values at points from averages over cells: the slope of the cumulative distribution, which is
/// known on the edges and interpolated between them by polynomials of degree 7 as
/// transform::MassTransfer does it. So each cell keeps its mass, and of a smooth function the
/// values are of seventh order. No polynomial reaches across an edge at 0, and on an edge the cell
/// after it counts (at the last one the last). 0 beyond the ends.
/// @param edges n + 1, increasing
/// @return shape (points, n)
SparseRows reconstruction(std::span<const double> edges, std::span<const double> points);

}  // namespace fpkcheck::backward
