#pragma once

#include <Eigen/SparseCore>
#include <span>

namespace fpkcheck::backward {

using RowMajorSparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Matrix that maps cell averages to values at points. The values are the slope of the cumulative
/// distribution, which polynomials of degree 7 interpolate between the edges (as in
/// transform::ConservativeRemap). Each cell therefore keeps its mass, and the values of a smooth
/// function have an error of seventh order in the cell width. No stencil crosses an edge at 0. A
/// point on an edge belongs to the cell after this edge, and a point on the last edge to the last
/// cell. Values beyond the ends are 0.
/// @param edges n + 1 cell edges, increasing
/// @return shape (points, n)
RowMajorSparseMatrix reconstruction_matrix(std::span<const double> edges,
                                           std::span<const double> points);

}  // namespace fpkcheck::backward
