#pragma once

namespace fpkcheck::fd_fpk {

/// The largest density in the cells along the upper x1 wall and along the two x2 walls of the box,
/// relative to a peak density. Zero where an impact wall replaces the wall of the box.
struct WallDensity {
  double x1;
  double x2;
  double x1_low = 0;  ///< along the left wall of the box, where no impact wall is
};

}  // namespace fpkcheck::fd_fpk
