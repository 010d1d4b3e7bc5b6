#pragma once

#include <optional>

#include "base/options/description.hpp"

namespace fpkcheck::problem {

/// A rigid wall; an impact multiplies y' by -restitution.
struct Wall {
  double position;
  double restitution;  ///< r, 0 < r <= 1
  bool operator==(const Wall&) const = default;
};

/// The section [wall] of a case file. The mass moves between the walls: left <= y <= right.
struct WallParameters {
  std::optional<double> left = {}, left_restitution = {};
  std::optional<double> right = {}, right_restitution = {};
  bool none = false;  ///< explicitly no wall

  bool operator==(const WallParameters&) const = default;
  /// Whether the section is absent.
  bool empty() const { return *this == WallParameters{}; }
};

/// The description of these parameters.
const base::Description<WallParameters>& wall_description();

/// The walls at the left and right ends of the motion; absent at open ends.
struct Walls {
  std::optional<Wall> left, right;
};

/// The walls of a case file: those of [wall], or one wall at y = 0 on the left with `restitution`
/// of [system] (the form of case files without [wall]).
/// @throws InputError where both or neither are given; where a position lacks its restitution or a
/// restitution its position; where left is not less than right
Walls make_walls(const WallParameters& parameters, const std::optional<double>& restitution);

}  // namespace fpkcheck::problem
