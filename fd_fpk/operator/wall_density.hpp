#pragma once

namespace fpkcheck::fd_fpk {

/// The largest density in the cells along the outer x1 wall and along the two x2 walls, relative to
/// some peak.
struct WallDensity {
  double x1;
  double x2;
};

}  // namespace fpkcheck::fd_fpk
