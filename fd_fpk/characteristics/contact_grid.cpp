#include "fd_fpk/characteristics/contact_grid.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fd_fpk/axis/faces_by_width.hpp"
#include "fd_fpk/characteristics/rest_points.hpp"

namespace fpkcheck::fd_fpk {
namespace {

constexpr double kCellWidth = 0.2;  // cell width far from rest points, in typical amplitudes
// Speed, in units of the typical speed, below which the impacts at a contact are treated as a
// cascade.
constexpr double kContactCore = 0.02;
// Limits of the distance to an equilibrium, in typical amplitudes, below which cells have a
// constant width: for rare impulses, and for frequent impulses, under which the motion hardly ever
// has smaller amplitudes. Around an equilibrium between walls the errors of the cells on both sides
// cancel in the mean. Towards an equilibrium at a wall the cell widths decrease further, to
// relative_core_width().
constexpr double kLeastCore = 1e-3, kMostCore = 0.1, kNothingLeft = 40;

// The typical speed, which is at least the speed due to half an impulse, even if impulses are rare.
double typical_contact_speed(const problem::Problem& problem, const problem::MotionScales& scales) {
  return std::max(scales.velocity_deviation, 0.5 * std::sqrt(problem.impulses.law().moment(2)));
}

// Typical distance to an equilibrium to which the motion decays between two impulses.
double equilibrium_core_distance(const problem::Problem& problem,
                                 const problem::MotionScales& scales, bool is_at_wall) {
  const double impulses = problem::impulses_per_decay_time(problem, scales);
  const double least = is_at_wall ? relative_core_width(scales.velocity_deviation,
                                                        typical_contact_speed(problem, scales))
                                  : kLeastCore;
  return std::clamp(std::exp(-kNothingLeft / impulses), least, kMostCore);
}

bool is_at_wall(const Flow& flow, const RestPoint& point) {
  const auto is_at = [&](WallSide side) {
    return flow.wall(side) && flow.wall(side)->position == point.y;
  };
  return is_at(WallSide::left) || is_at(WallSide::right);
}

struct TypicalScales {
  double speed, core_v;
  std::vector<RestPoint> points;
  std::vector<double> core_y = {};  // core of the grading in y, for each rest point
  // largest distance from a rest point that motion with the typical speed attains
  double widest = 0;
};

TypicalScales typical_scales(const problem::Problem& problem, const problem::MotionScales& scales,
                             const Flow& flow) {
  TypicalScales found{.speed = typical_contact_speed(problem, scales),
                      .core_v = kContactCore,
                      .points = rest_points(flow)};
  for (const RestPoint& point : found.points) {
    const AccessibleInterval accessible_interval = flow.accessible_interval({point.y, found.speed});
    const double length =
        std::max(point.y - accessible_interval.low, accessible_interval.high - point.y);
    found.widest = std::max(found.widest, length);
    if (point.contact) {
      // The first cell in y has the height of a flight whose speed is the width of the first cell
      // in v.
      const double slow = kCellWidth * kContactCore * found.speed;
      const double height = slow * slow / (2 * std::abs(flow.force(point.y)));
      found.core_y.push_back(height / kCellWidth);
    } else {
      const double core = equilibrium_core_distance(problem, scales, is_at_wall(flow, point));
      found.core_y.push_back(core * length);
      found.core_v = std::min(found.core_v, core);
    }
  }
  return found;
}

}  // namespace

Grid contact_grid(const problem::Problem& problem, const problem::MotionScales& scales,
                  const Options& options, const Box& box) {
  const Flow flow(problem.system);
  const TypicalScales scale = typical_scales(problem, scales, flow);
  const double part = kCellWidth / options.refinement;
  double least = flow.potential(scale.points.front().y);
  for (const RestPoint& point : scale.points) least = std::min(least, flow.potential(point.y));
  std::vector<double> anchors{box.x1_min};
  for (const RestPoint& point : scale.points) {
    if (point.y > anchors.back() && point.y < box.x1_max) anchors.push_back(point.y);
  }
  anchors.push_back(box.x1_max);
  const auto width_in_y = [&](double y) {
    const double speed = std::sqrt(2 * std::max(0.0, flow.potential(y) - least));
    // Near a saddle the force does not determine the length scale of the density.
    double nearest = scale.widest;
    for (const RestPoint& point : scale.points) {
      nearest = std::max(nearest, std::abs(y - point.y) / 4);
    }
    double inverse = std::max(
        1 / nearest, std::abs(flow.force(y)) / (std::max(speed, scale.speed) * scale.speed));
    for (std::size_t k = 0; k < scale.points.size(); ++k) {
      inverse += 1 / (scale.core_y[k] + std::abs(y - scale.points[k].y));
    }
    return part / inverse;
  };
  const std::vector<double> speeds{0, box.x2_max};
  const auto width_in_v = [&](double v) {
    return part / (1 / scale.speed + 1 / (scale.core_v * scale.speed + v));
  };
  const auto beyond = [&](WallSide side) {
    return flow.wall(side) ? EndCondition::boundary : EndCondition::vacuum;
  };
  return symmetric_grid(faces_with_local_width(anchors, width_in_y),
                        faces_with_local_width(speeds, width_in_v), beyond(WallSide::left),
                        beyond(WallSide::right));
}

Box initial_contact_box(const problem::Problem& problem, const problem::MotionScales& scales,
                        const Options& options) {
  constexpr double kTimes = 5, kDeviations = 9, kHigher = 1.1;
  const Flow flow(problem.system);
  const auto& law = problem.impulses.law();
  Box box{.x1_max = 0,
          .x2_max = options.x2_max.value_or(kTimes * typical_contact_speed(problem, scales) +
                                            std::abs(law.mean()) + kDeviations * law.deviation())};
  double lowest = 0, highest = 0;
  for (const RestPoint& point : rest_points(flow)) {
    const AccessibleInterval accessible_interval = flow.accessible_interval({point.y, box.x2_max});
    lowest = std::min(lowest, accessible_interval.low);
    highest = std::max(highest, accessible_interval.high);
  }
  const auto& left = flow.wall(WallSide::left);
  const auto& right = flow.wall(WallSide::right);
  box.x1_min = left ? left->position : kHigher * lowest;
  box.x1_max = right ? right->position : options.x1_max.value_or(kHigher * highest);
  return box;
}

}  // namespace fpkcheck::fd_fpk
