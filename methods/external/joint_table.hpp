#pragma once

#include <string>
#include <vector>

#include "methods/external/density_points.hpp"
#include "methods/external/number_table.hpp"

namespace fpkcheck::methods {

/// The values of a joint density at the points of a rectangular grid.
struct JointTable {
  std::vector<double> y, v;  ///< grid points in y and in y': increasing, at least four values each
  std::vector<double> p;     ///< values of the density, row-major, shape (y, v)
};

/// Whether a table is a joint density: three columns with the names of y, y' and a density, such as
/// "y,v,p".
bool is_joint_density(const NumberTable& table);

/// Converts three columns to a joint table. The columns are y and y' in either order, then the
/// density. There is one row for every grid point; the rows may have any order.
/// @throws InputError with a message of one line, if a point is missing or occurs twice, or if
///         there are too few points
JointTable make_joint_table(const NumberTable& table);

/// Tests that the axes of a joint table increase and are long enough, and that all numbers are
/// finite and not too large.
/// @throws InputError with a message "SOURCE: problem", if a test fails
void require_valid_joint_table(const JointTable& table, const std::string& source);

/// Tests that a range of y is between the walls.
/// @param from, to first and last y
/// @throws InputError with a message "SOURCE: problem", if `from` or `to` is behind a wall
void require_between_walls(const problem::Walls& walls, double from, double to,
                           const std::string& source);

/// Interpolates a joint density at quadrature points, by Akima's modified interpolant along y' and
/// then along y, as ExternalMarginal. Interpolated values below the minimum of the table and below
/// 0 are raised to the lower of these two limits. If the first or last y of the table is not
/// farther from a wall than from its neighbour, the density is extrapolated linearly to the wall.
/// Elsewhere outside the table the density is 0.
/// @return values at the points, row-major, shape (points.y_points(), points.v_points())
std::vector<double> evaluate_at(const JointTable& table, const DensityPoints& points);

/// Values at quadrature points that reproduce the averages of a density over cells. The values are
/// averages over the subcells of the points (subcell_edges), transferred by the cumulative
/// distribution (transform::average_over_cells). Values below the lowest average and below 0 are
/// raised to the lower of these two limits.
/// @return values at the points, row-major, shape (points.y_points(), points.v_points())
std::vector<double> evaluate_at(const transform::GridDensity& cells, const DensityPoints& points);

}  // namespace fpkcheck::methods
