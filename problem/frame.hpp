#pragma once

namespace fpkcheck::problem {

class System;
struct Problem;

/// Wall coordinates x of a problem: y = origin + x, or y = origin - x when mirrored (velocities
/// then change sign too). The wall is at x = 0 and the mass at x > 0; a second wall is on the
/// right. For a problem with one wall at y = 0 on the left, or without walls, x = y.
struct Frame {
  double origin = 0;
  bool mirrored = false;

  double sign() const { return mirrored ? -1 : 1; }
  double y(double x) const { return origin + sign() * x; }
  double x(double y) const { return sign() * (y - origin); }
  /// The velocity y' for x'.
  double v(double x_dot) const { return sign() * x_dot; }
  bool is_identity() const { return origin == 0 && !mirrored; }
  /// The inverse transformation.
  Frame inverse() const {
    return {.origin = -sign() * origin + 0.0, .mirrored = mirrored};  // avoids -0
  }
  bool operator==(const Frame&) const = default;
};

/// The wall coordinates of a system: from the left wall, or from the right wall when it is the only
/// one.
Frame wall_frame(const System& system);

/// The problem in wall coordinates, with Problem::frame set. For the identity the problem is
/// returned unchanged, with the frame that it has. Its name and its parameters as in the case file
/// are kept.
Problem to_wall_coordinates(const Frame& frame, const Problem& problem);

}  // namespace fpkcheck::problem
