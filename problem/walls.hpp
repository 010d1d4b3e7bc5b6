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

class System;
struct Problem;

/// The transformation between the physical coordinate y of a problem and its wall coordinate x: y =
/// origin + x, or, if mirrored, y = origin - x with the velocities of opposite sign. In wall
/// coordinates the wall is at x = 0 and the mass at x > 0; a second wall is on the right. For a
/// problem with one wall at y = 0 on the left, or without walls, x = y.
struct Frame {
  double origin = 0;
  bool mirrored = false;

  double sign() const { return mirrored ? -1 : 1; }
  double physical_y(double x) const { return origin + sign() * x; }
  double wall_x(double y) const { return sign() * (y - origin); }
  /// The physical velocity y' for the velocity x' in wall coordinates.
  double physical_velocity(double x_dot) const { return sign() * x_dot; }
  bool is_identity() const { return origin == 0 && !mirrored; }
  /// The inverse transformation.
  Frame inverse() const {
    return {.origin = -sign() * origin + 0.0, .mirrored = mirrored};  // avoids -0
  }
  bool operator==(const Frame&) const = default;
};

/// The wall coordinates of a system. Their origin is the left wall, or the right wall if there is
/// no left wall.
Frame wall_frame(const System& system);

/// Transforms a problem to the wall coordinates of `frame` and sets Problem::frame. If `frame` is
/// the identity, the problem is returned unchanged, Problem::frame included. The name of the
/// problem and its parameters as in the case file are kept.
Problem to_wall_coordinates(const Frame& frame, const Problem& problem);

}  // namespace fpkcheck::problem
