#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "problem/walls.hpp"

/// Tests of external data against the range of y that the walls of a case admit. A point on a wall
/// is in the range. The tolerance is a millionth of the position of the wall, since the numbers in
/// files are rounded.
namespace fpkcheck::methods {

/// Whether y is at the wall, within the tolerance. False if there is no wall.
bool is_at_wall(const std::optional<problem::Wall>& wall, double y);
/// Whether y is in the range that the walls admit, within the tolerance.
bool is_between_walls(const problem::Walls& walls, double y);

/// The walls to which a density is extrapolated. The density is extrapolated to a wall if the
/// distance from the wall to the nearest abscissa is at most the spacing of the abscissae there.
/// This condition holds if the abscissae are centres of cells that begin at the wall.
struct WallExtrapolation {
  bool left = false, right = false;  ///< whether the density is extrapolated to this wall
};
/// Selects the walls to which a density is extrapolated.
/// @param y abscissae of the density: increasing, at least two
WallExtrapolation walls_to_extrapolate_to(const problem::Walls& walls,
                                          const std::vector<double>& y);

/// The value at a wall by linear extrapolation from the points with the indices `first` and
/// `first` + 1. If the extrapolated value is below `least`, the result is `least`.
double extrapolate_to_wall(double wall, std::span<const double> y, std::span<const double> values,
                           std::size_t first, double least);

/// The range of y that the walls admit, as text: "y >= 0", "y <= 1", "-0.5 <= y <= 1"; "any y" if
/// there is no wall.
std::string admissible_range_text(const problem::Walls& walls);

}  // namespace fpkcheck::methods
