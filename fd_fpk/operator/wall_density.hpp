#pragma once

namespace fpkcheck::fd_fpk {

/// The largest density in the cells along the outer x1 wall and along the two x2 walls, relative to
/// some peak. (Walls of the box: none where an impact wall stands.)
struct WallDensity {
  double x1;
  double x2;
  double x1_low = 0;  ///< along the wall of the box on the left, where the motion is free there
};

}  // namespace fpkcheck::fd_fpk
