#pragma once

#include <string>
#include <vector>

#include "methods/external/density_points.hpp"
#include "methods/external/number_table.hpp"

namespace fpkcheck::methods {

/// A joint density at the points of a rectangular grid.
struct JointTable {
  std::vector<double> y, v;  ///< increasing, at least four values each
  std::vector<double> p;     ///< row-major, shape (y, v)
};

/// True for three columns with the names of y, y' and a density, such as "y,v,p".
bool is_joint_density(const NumberTable& table);

/// Converts three columns: y and y' in either order, then the density. There is one row for every
/// grid point, in any order.
/// @throws InputError on one line: a point that is missing or occurs twice, too few points
JointTable make_joint_table(const NumberTable& table);

/// @throws InputError SOURCE: problem, where an axis is too short or does not increase, or a number
///         is too large or not finite
void require_usable(const JointTable& table, const std::string& source);

/// @throws InputError SOURCE: problem, where the first or last y is behind a wall
void require_between_walls(const problem::Walls& walls, double from, double to,
                           const std::string& source);

/// The values at the points: Akima's modified interpolant along y' and then along y, as for
/// marginals (ExternalMarginal), but not below the table's minimum or 0, whichever is lower. A
/// first or last y that is no farther from the wall than from its neighbour is extrapolated
/// linearly to the wall. Elsewhere outside the table the density is 0.
/// @return row-major, shape (points.y(), points.v())
std::vector<double> evaluate_at(const JointTable& table, const DensityPoints& points);

/// The values at the points that reproduce a density's averages over cells. They are averages over
/// the subcells of the points (subcell_edges), transferred by the cumulative distribution
/// (transform::average_over_cells), but not below the lowest average or 0, whichever is lower.
/// @return row-major, shape (points.y(), points.v())
std::vector<double> evaluate_at(const transform::GridDensity& cells, const DensityPoints& points);

}  // namespace fpkcheck::methods
