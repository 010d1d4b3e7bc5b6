#include "fd_fpk/operator/resolution.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fpkcheck::fd_fpk {

std::string box_objection(const Grid& grid, const WallDensity& wall, const std::string& when) {
  if (wall.x1 <= kMostOnWall && wall.x2 <= kMostOnWall && wall.x1_low <= kMostOnWall) return "";
  if (grid.x1.left() == Beyond::vacuum) {
    return fmt::format(
        "the box {:.3g} <= y <= {:.3g}, |y'| <= {:.3g} is too small: {}the density on its wall is "
        "{:.1e} of the peak (widen it with y-max and v-max)",
        grid.x1_min(), grid.x1_max(), grid.x2_max(), when,
        std::max({wall.x1, wall.x2, wall.x1_low}));
  }
  return fmt::format(
      "the box y <= {:.3g}, |y'| <= {:.3g} is too small: {}the density on its wall is {:.1e} of the "
      "peak (widen it with y-max and v-max)",
      grid.x1_max(), grid.x2_max(), when, std::max(wall.x1, wall.x2));
}

}  // namespace fpkcheck::fd_fpk
