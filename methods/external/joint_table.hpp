#pragma once

#include <string>
#include <vector>

#include "methods/external/density_points.hpp"
#include "methods/external/number_table.hpp"

namespace fpkcheck::methods {

/// A joint density as a file has it, point by point on a rectangular grid.
struct JointTable {
  std::vector<double> y, v;  ///< increasing, four at least
  std::vector<double> p;     ///< row-major, shape (y, v)
};

/// True for three columns whose names are those of y, of y' and of a density: "y,v,p".
bool is_joint(const NumberTable& table);

/// Three columns, y and y' in either order and the density, with a row for every point of the grid
/// in any order of the rows.
/// @throws InputError on one line: a point that is missing or there twice, too few of them
JointTable joint_table_of(const NumberTable& table);

/// @throws InputError SOURCE: problem, where the axes do not increase, are too short, or a number
///         is not finite or too large
void require_usable(const JointTable& table, const std::string& source);

/// @throws InputError SOURCE: problem, where a first or last y lies behind a wall
void require_between(const problem::Walls& walls, double from, double to,
                     const std::string& source);

/// Its values at the points: Akima's modified interpolant along y' and then along y, as of
/// marginals (GivenMarginal), no lower than the least value of the table. From a first or last y
/// that is no farther from the wall than from its neighbour it is continued to the wall by straight
/// lines. Elsewhere outside the table it is 0.
/// @return row-major, shape (points.y(), points.v())
std::vector<double> values_at(const JointTable& table, const DensityPoints& points);

/// The values at the points that have the averages of a density on cells: over the parts of each
/// cell (edges_of_parts), carried over by its cumulative distribution (transform::average_over_cells), no
/// lower than the least of its averages.
std::vector<double> values_at(const transform::GridDensity& cells, const DensityPoints& points);

}  // namespace fpkcheck::methods
