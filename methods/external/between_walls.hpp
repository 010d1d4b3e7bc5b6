#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "problem/walls.hpp"

/// The range of y that the walls of a case admit, for checks of external data. A point on a wall is
/// in the range. The tolerance is a millionth of the wall's position, since files have rounded
/// numbers.
namespace fpkcheck::methods {

bool is_at_wall(const std::optional<problem::Wall>& wall, double y);
bool is_between_walls(const problem::Walls& walls, double y);

/// The walls to which a density is extrapolated: those whose distance to the first or last abscissa
/// is at most the spacing of the abscissae there, as for the centres of cells.
struct WallExtrapolation {
  bool left = false, right = false;
};
/// @param y increasing, at least two
WallExtrapolation walls_to_extrapolate_to(const problem::Walls& walls,
                                          const std::vector<double>& y);

/// The value at the wall of the straight line through the points `first` and `first` + 1; at least
/// `least`.
double extrapolate_to_wall(double wall, std::span<const double> y, std::span<const double> values,
                           std::size_t first, double least);

/// The range of y as text: "y >= 0", "y <= 1", "-0.5 <= y <= 1"; "any y" without walls.
std::string admissible_range_text(const problem::Walls& walls);

}  // namespace fpkcheck::methods
