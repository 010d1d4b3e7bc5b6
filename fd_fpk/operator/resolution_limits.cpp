#include "fd_fpk/operator/resolution_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace fpkcheck::fd_fpk {
namespace {

// Text of the ends of y that are not impact walls: "-2 <= y <= 3, ", "y <= 3, " or "y >= -2, ";
// empty if both ends are impact walls.
std::string box_ends_text(const problem::Frame& frame, const Axis& x1) {
  bool low = x1.left_end_condition() == EndCondition::vacuum,
       high = x1.right_end_condition() == EndCondition::vacuum;
  double from = frame.physical_y(x1.faces().front()), to = frame.physical_y(x1.faces().back());
  if (frame.mirrored) {
    std::swap(low, high);
    std::swap(from, to);
  }
  if (low && high) return fmt::format("{:.3g} <= y <= {:.3g}, ", from, to);
  if (high) return fmt::format("y <= {:.3g}, ", to);
  return low ? fmt::format("y >= {:.3g}, ", from) : "";
}

}  // namespace

std::string box_failure_reason(const problem::Frame& frame, const Grid& grid,
                               const WallDensity& wall, const std::string& when) {
  if (wall.x1 <= kMaxWallDensity && wall.x2 <= kMaxWallDensity && wall.x1_low <= kMaxWallDensity)
    return "";
  return fmt::format(
      "the box {}|y'| <= {:.3g} is too small: {}the density on its wall is {:.1e} of the peak; "
      "increase y-max and v-max",
      box_ends_text(frame, grid.x1), grid.x2_max(), when,
      std::max({wall.x1, wall.x2, wall.x1_low}));
}

}  // namespace fpkcheck::fd_fpk
