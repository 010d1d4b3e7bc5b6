#pragma once

#include <Eigen/SparseCore>
#include <optional>
#include <span>

#include "fd_fpk/axis/axis.hpp"
#include "numerics/polynomials/polynomial.hpp"

/// One-dimensional operators on cell averages of an axis. The operator of the plane is a sum of
/// tensor products of these. Each is exact on polynomials up to a degree given by its order.
namespace fpkcheck::fd_fpk {

using AxisOperator = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The upstream side of a face: stencils of odd length have one cell more on this side.
enum class Bias { left, right };

/// Point values on the inner faces 1 .. cells-1, shape (cells + 1, cells); the rows of the two end
/// faces are zero. Stencils have `points` cells and are exact on averages of polynomials of degree
/// points-1; centred for even `points`, with one cell more upstream for odd `points`.
AxisOperator face_values(const Axis& axis, int points, Bias bias);

/// As face_values, for the derivative; centred stencils, even `points`.
AxisOperator face_derivatives(const Axis& axis, int points);

/// The value at face 0 by extrapolation from the first `points` cells, shape (1, cells).
AxisOperator first_face_value(const Axis& axis, int points);

/// The value at the last face by extrapolation from the last `points` cells, shape (1, cells).
AxisOperator last_face_value(const Axis& axis, int points);

/// Averages of weight(x) p over each cell from averages of p, shape (cells, cells). Stencils of
/// `points` cells (odd) do not cross the inner face `barrier`, if given.
AxisOperator weighted_averages(const Axis& axis, int points, const numerics::Polynomial& weight,
                               std::optional<int> barrier = {});

/// Point values inside the cells: row i n + k is the value at face(i) + fractions[k] width(i), with
/// n the number of fractions, shape (n cells, cells). Stencils as in weighted_averages.
AxisOperator point_values(const Axis& axis, int points, std::span<const double> fractions,
                          std::optional<int> barrier = {});

/// (F[f+1] - F[f]) / width, shape (cells, cells + 1).
AxisOperator divergence(const Axis& axis);

/// Stencil length of centred differences of this order.
constexpr int centred_points(int order) { return order + order % 2; }

/// Stencil length of weighted_averages for this order: the order of the averages is points + 1.
constexpr int weighting_points(int order) { return order % 2 == 1 ? order : order - 1; }

}  // namespace fpkcheck::fd_fpk
