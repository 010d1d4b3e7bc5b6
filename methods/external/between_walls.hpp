#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "problem/walls.hpp"

/// Where the mass of a case can be: what others say of y is held to it. On a wall counts, to a
/// millionth of its position, since files have rounded numbers.
namespace fpkcheck::methods {

bool is_at(const std::optional<problem::Wall>& wall, double y);
bool is_between(const problem::Walls& walls, double y);

/// Walls next to which abscissae begin and end: no farther from them than from each other, as the
/// centres of cells.
struct Reached {
  bool left = false, right = false;
};
/// @param y increasing, two at least
Reached reached_from(const problem::Walls& walls, const std::vector<double>& y);

/// The straight line through the points `first` and the next, at the wall; no lower than `least`.
double continued_to(double wall, std::span<const double> y, std::span<const double> values,
                    std::size_t first, double least);

/// "y >= 0", "y <= 1", "-0.5 <= y <= 1"; "any y" without walls.
std::string between(const problem::Walls& walls);

}  // namespace fpkcheck::methods
