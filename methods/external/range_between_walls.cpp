#include "methods/external/range_between_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fpkcheck::methods {

bool is_at_wall(const std::optional<problem::Wall>& wall, double y) {
  constexpr double kRounding = 1e-6;
  return wall && std::abs(y - wall->position) <= kRounding * std::abs(wall->position);
}

bool is_between_walls(const problem::Walls& walls, double y) {
  const auto& [left, right] = walls;
  return (!left || y >= left->position || is_at_wall(left, y)) &&
         (!right || y <= right->position || is_at_wall(right, y));
}

WallExtrapolation select_extrapolation_walls(const problem::Walls& walls,
                                             const std::vector<double>& y) {
  const auto& [left, right] = walls;
  const std::size_t last = y.size() - 1;
  return {.left = left && !is_at_wall(left, y[0]) && y[0] > left->position &&
                  y[0] - left->position <= y[1] - y[0],
          .right = right && !is_at_wall(right, y[last]) && y[last] < right->position &&
                   right->position - y[last] <= y[last] - y[last - 1]};
}

double extrapolate_to_wall(double wall, std::span<const double> y, std::span<const double> values,
                           std::size_t first, double least) {
  const double slope = (values[first + 1] - values[first]) / (y[first + 1] - y[first]);
  return std::max(values[first] + slope * (wall - y[first]), least);
}

std::string admissible_range_text(const problem::Walls& walls) {
  const auto& [left, right] = walls;
  if (left && right) return fmt::format("{:g} <= y <= {:g}", left->position, right->position);
  if (left) return fmt::format("y >= {:g}", left->position);
  return right ? fmt::format("y <= {:g}", right->position) : "any y";
}

}  // namespace fpkcheck::methods
