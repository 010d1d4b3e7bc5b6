#pragma once

#include <optional>

#include "base/options/description.hpp"

namespace fpkcheck::problem {

/// A rigid wall. An impact at the wall multiplies the velocity y' by -restitution.
struct Wall {
  double position;
  double restitution;  ///< coefficient of restitution r, 0 < r <= 1
  bool operator==(const Wall&) const = default;
};

/// The section [wall] of a case file: positions and restitution coefficients of the walls. The mass
/// moves in left <= y <= right.
struct WallParameters {
  std::optional<double> left = {}, left_restitution = {};
  std::optional<double> right = {}, right_restitution = {};
  bool none = false;  ///< whether the case file states that there is no wall

  bool operator==(const WallParameters&) const = default;
  /// Whether the case file has no section [wall].
  bool empty() const { return *this == WallParameters{}; }
};

/// The description of the parameters of the section [wall].
const base::Description<WallParameters>& wall_parameter_description();

/// The walls at the left and right ends of the interval of y. A wall is absent where the interval
/// is unbounded.
struct Walls {
  std::optional<Wall> left, right;
};

/// The walls that a case file defines: the walls of the section [wall]; or, without this section,
/// one wall at y = 0 on the left with `restitution` of the section [system].
/// @throws InputError if both [wall] and `restitution` are given, or neither; if a wall has a
/// position without a restitution or a restitution without a position; or if left >= right
Walls make_walls(const WallParameters& parameters, const std::optional<double>& restitution);

}  // namespace fpkcheck::problem
