#pragma once

#include <optional>

#include "base/options/description.hpp"

namespace fpkcheck::problem {

/// A rigid wall: y' is multiplied by -restitution there.
struct Wall {
  double position;
  double restitution;  ///< r, 0 < r <= 1
  bool operator==(const Wall&) const = default;
};

/// The section [wall] of a case file. The mass moves between the walls: y >= left, y <= right.
struct WallParameters {
  std::optional<double> left = {}, left_restitution = {};
  std::optional<double> right = {}, right_restitution = {};
  bool none = false;  ///< there is no wall, and that is meant

  bool operator==(const WallParameters&) const = default;
  /// Nothing is said of walls.
  bool empty() const { return *this == WallParameters{}; }
};

/// The parameters as case files, tables and files name them.
const base::Description<WallParameters>& wall_description();

/// What stands at the left and right ends of the motion.
struct Walls {
  std::optional<Wall> left, right;
};

/// The walls that a case file means: those of [wall], or one at y = 0 on the left with
/// `restitution` of [system], as it was before there was such a section.
/// @throws InputError where both are given, or neither; where a position is without restitution, or a
///         restitution without position; where left is not left of right
Walls walls_of(const WallParameters& parameters, const std::optional<double>& restitution);

}  // namespace fpkcheck::problem
