#pragma once

#include <string>
#include <vector>

#include "methods/external/density_quadrature.hpp"
#include "methods/external/number_table.hpp"

namespace fpkcheck::methods {

struct JointTable {
  std::vector<double> y, v;  ///< increasing grid points in y and in y', at least four each
  std::vector<double> p;     ///< values of the density, row-major, shape (y, v)
};

/// Returns whether a table is a joint density: three columns with the names of y, y' and a density,
/// such as "y,v,p".
bool is_joint_density(const NumberTable& table);

/// Converts a table with the columns y, y' (in either order) and density to a JointTable. Each grid
/// point must have exactly one row of the table; the order of the rows is arbitrary.
/// @throws InputError with a message of one line, if the grid has too few points, or if a grid
/// point is missing or occurs twice
JointTable make_joint_table(const NumberTable& table);

/// Checks that the grid points of a joint density increase, that each axis has enough points, and
/// that all numbers are finite and not too large.
/// @throws InputError with a message "SOURCE: problem"
void require_valid_joint_table(const JointTable& table, const std::string& source);

/// @throws InputError with a message "SOURCE: problem", if `from` or `to` is behind a wall
void require_range_between_walls(const problem::Walls& walls, double from, double to,
                                 const std::string& source);

/// Interpolates a joint density at quadrature points by Akima's modified interpolant, along y' and
/// then along y. Interpolated values of the density are clipped from below at the smaller of 0 and
/// the minimum of the table. The density is extrapolated linearly to a wall near the first or last
/// value of y (WallExtrapolation). At all other points outside the range of the table the density
/// is 0.
/// @return values at the points, row-major, shape (points.y_points(), points.v_points())
std::vector<double> evaluate_at_quadrature_points(const JointTable& table,
                                                  const DensityQuadratureGrid& points);

/// Returns values at quadrature points that reproduce the averages of a density over cells. The
/// value at a quadrature point is the average of the density over the subcell of the point
/// (subcell_edges), computed from the cumulative distribution (transform::average_over_cells). The
/// values at the quadrature points are clipped from below at the smaller of 0 and the lowest cell
/// average.
/// @return values at the points, row-major, shape (points.y_points(), points.v_points())
std::vector<double> evaluate_at_quadrature_points(const transform::GridDensity& cells,
                                                  const DensityQuadratureGrid& points);

}  // namespace fpkcheck::methods
