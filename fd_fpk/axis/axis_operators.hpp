#pragma once

#include <Eigen/SparseCore>
#include <optional>
#include <span>

#include "fd_fpk/axis/grid.hpp"
#include "numerics/polynomials/polynomial.hpp"

/// One-dimensional operators on cell averages of an axis. The operator of the phase plane is a sum
/// of tensor products of these one-dimensional operators. Each one-dimensional operator is exact on
/// polynomials up to a degree that its order of accuracy determines.
namespace fpkcheck::fd_fpk {

using AxisOperator = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The upstream side of a face. Stencils with an odd number of cells have one cell more on the
/// upstream side of the face than on the other side.
enum class UpstreamSide { left, right };

/// The matrix that maps cell averages to point values on the inner faces 1 .. cells-1, shape (cells
/// + 1, cells). The rows for the two end faces of the axis are zero. Stencils have `stencil_size`
/// cells and are exact on averages of polynomials of degree stencil_size-1. Stencils with an even
/// number of cells are centred.
AxisOperator face_value_operator(const Axis& axis, int stencil_size, UpstreamSide upstream_side);

/// The matrix that maps cell averages to derivatives on the inner faces of the axis, with the shape
/// of face_value_operator. The stencils are centred and have an even number `stencil_size` of
/// cells.
AxisOperator face_derivative_operator(const Axis& axis, int stencil_size);

/// The row vector that maps cell averages to the value at the first or the last face of the axis,
/// by extrapolation from the nearest `stencil_size` cells, shape (1, cells).
AxisOperator end_value_operator(const Axis& axis, AxisEnd end, int stencil_size);

/// The matrix that maps averages of p to averages of weight(x) p over each cell, shape (cells,
/// cells). The stencils have an odd number `stencil_size` of cells, and do not cross the inner face
/// `barrier` if this face is given.
AxisOperator weighted_average_operator(const Axis& axis, int stencil_size,
                                       const numerics::Polynomial& weight,
                                       std::optional<int> barrier = {});

/// The matrix that maps cell averages to point values inside the cells, shape (n cells, cells),
/// with n the number of fractions. Row i n + k of the matrix gives the value at face(i) +
/// fractions[k] width(i). The stencils are those of weighted_average_operator.
AxisOperator point_value_operator(const Axis& axis, int stencil_size,
                                  std::span<const double> fractions,
                                  std::optional<int> barrier = {});

/// The matrix that maps face values F to the divergence (F[f+1] - F[f]) / width in each cell, shape
/// (cells, cells + 1).
AxisOperator divergence_operator(const Axis& axis);

/// Number of cells in a stencil of centred differences with the given order of accuracy.
constexpr int centred_stencil_size(int order) { return order + order % 2; }

/// Smallest number of cells in a stencil of weighted_average_operator that suffices for a scheme of
/// the given order. With n cells in the stencil the averages are accurate to order n + 1.
constexpr int averaging_stencil_size(int order) { return order % 2 == 1 ? order : order - 1; }

}  // namespace fpkcheck::fd_fpk
