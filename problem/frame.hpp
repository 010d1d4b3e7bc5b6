#pragma once

namespace fpkcheck::problem {

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
