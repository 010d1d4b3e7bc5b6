#pragma once

#include <Eigen/SparseCore>
#include <optional>
#include <span>

#include "fd_fpk/line/line.hpp"
#include "numerics/polynomials/polynomial.hpp"

/// One-dimensional operators on cell averages of a line. The plane's operator is a sum of
/// tensor products of these. Each is exact on polynomials up to a degree that its order states.
namespace fpkcheck::fd_fpk {

using LineOperator = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Which side of a face a stencil of odd length prefers: the side the flow comes from.
enum class Bias { left, right };

/// Point values on the inner faces 1 .. cells-1, shape (cells + 1, cells); the rows of the two end
/// faces are zero. `points` cells a stencil, so exact on averages of polynomials of degree
/// points-1; centred for even `points`, one cell more upstream for odd ones.
LineOperator face_values(const Line& line, int points, Bias bias);

/// As face_values, for the derivative; centred, even `points`.
LineOperator face_derivatives(const Line& line, int points);

/// The value at face 0 by extrapolation from the first `points` cells, shape (1, cells).
LineOperator end_value(const Line& line, int points);

/// The same at the last face from the last cells.
LineOperator last_value(const Line& line, int points);

/// Averages of weight(x) p over each cell from averages of p, shape (cells, cells). Stencils of
/// `points` cells (odd) do not reach across the inner face `barrier`, if one is given.
LineOperator weighted_averages(const Line& line, int points, const numerics::Polynomial& weight,
                               std::optional<int> barrier = {});

/// Point values within the cells: row i n + k holds the value at face(i) + fractions[k] width(i),
/// where n is the number of fractions, shape (n cells, cells). Stencils as of weighted_averages.
LineOperator point_values(const Line& line, int points, std::span<const double> fractions,
                          std::optional<int> barrier = {});

/// (F[f+1] - F[f]) / width, shape (cells, cells + 1).
LineOperator divergence(const Line& line);

/// Length of the centred stencils that keep an order.
constexpr int centred_points(int order) { return order + order % 2; }

/// Length of the stencil of weighted_averages that keeps an order: its own order is points + 1.
constexpr int weighting_points(int order) { return order % 2 == 1 ? order : order - 1; }

}  // namespace fpkcheck::fd_fpk
