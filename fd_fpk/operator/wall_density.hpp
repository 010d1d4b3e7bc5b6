#pragma once

namespace fpkcheck::fd_fpk {

/// The largest density in the cells along the upper x1 wall and along the two x2 walls of the box,
/// relative to a peak density. Zero at an end of the box that is an impact wall.
struct WallDensity {
  double x1;
  double x2;
  double x1_low = 0;  ///< density along the left end of the box; 0 if that end is an impact wall
};

}  // namespace fpkcheck::fd_fpk
