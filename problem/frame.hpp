#pragma once

namespace fpkcheck::problem {

class System;
struct Problem;

/// Coordinates x in which a problem is solved: y = origin + x, or y = origin - x when mirrored
/// (velocities change their sign then, too). In them the wall stands at x = 0 and the mass moves at
/// x > 0; a second wall is at the right. What has its one wall at y = 0 on the left, or none, is
/// solved as it stands.
struct Frame {
  double origin = 0;
  bool mirrored = false;

  double sign() const { return mirrored ? -1 : 1; }
  double y(double x) const { return origin + sign() * x; }
  double x(double y) const { return sign() * (y - origin); }
  /// y' of x'.
  double v(double x_dot) const { return sign() * x_dot; }
  bool is_identity() const { return origin == 0 && !mirrored; }
  /// By which x is seen from y.
  Frame inverse() const {
    return {.origin = -sign() * origin + 0.0, .mirrored = mirrored};  // no -0
  }
  bool operator==(const Frame&) const = default;
};

/// From the left wall; from the right one where it is the only one.
Frame frame_of(const System& system);

/// The problem in coordinates x, with Problem::frame; as it stands, with the frame that it has,
/// where they are its own. The name, and the parameters as the case file has them, stay.
Problem seen_from(const Frame& frame, const Problem& problem);

}  // namespace fpkcheck::problem
