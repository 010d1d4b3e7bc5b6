#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "problem/walls.hpp"

/// Checks that values of y in external data are between the walls. The tolerance for values of y
/// behind a wall is 1e-6 of the wall position, since numbers in files are rounded.
namespace fpkcheck::methods {

/// Returns whether y equals the position of a wall within a tolerance; false if the wall is absent.
bool is_at_wall(const std::optional<problem::Wall>& wall, double y);
bool is_between_walls(const problem::Walls& walls, double y);

/// The walls to which an external density is extrapolated: walls whose distance from the nearest
/// abscissa is at most the spacing of the abscissae.
struct WallExtrapolation {
  bool left = false, right = false;
};
/// @param y increasing abscissae of the density, at least two
WallExtrapolation select_extrapolation_walls(const problem::Walls& walls,
                                             const std::vector<double>& y);

/// Returns the value of a density at a wall by linear extrapolation from the points `first` and
/// `first` + 1. Extrapolated values below `least` are replaced by `least`.
double extrapolate_to_wall(double wall, std::span<const double> y, std::span<const double> values,
                           std::size_t first, double least);

/// Returns the range of y between walls as text: "y >= 0", "-0.5 <= y <= 1" or "any y".
std::string admissible_range_text(const problem::Walls& walls);

}  // namespace fpkcheck::methods
