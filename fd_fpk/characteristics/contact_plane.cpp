#include "fd_fpk/characteristics/contact_plane.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fd_fpk/characteristics/rest.hpp"
#include "fd_fpk/line/faces_by_width.hpp"

namespace fpkcheck::fd_fpk {
namespace {

constexpr double kCellWidth = 0.2;  // in typical amplitudes
// In units of the typical speed: at lower speeds the impacts in contact form a cascade.
constexpr double kContactCore = 0.02;
// Lower limits of the distance to an equilibrium, in typical amplitudes, below which cells have a
// constant width: for rare impulses, and for frequent impulses, which leave no motion at smaller
// distances. Cells on both sides of a well do not bias its mean; cells towards an equilibrium at a
// wall decrease further, to relative_core_width().
constexpr double kLeastCore = 1e-3, kMostCore = 0.1, kNothingLeft = 40;

// The typical speed is at least half an impulse, even for rare impulses.
double usual_speed_in_contact(const problem::Problem& problem, const problem::Scales& scales) {
  return std::max(scales.velocity_deviation, 0.5 * std::sqrt(problem.impulses.law().moment(2)));
}

// Distance to the equilibrium to which the motion decays between impulses.
double equilibrium_core(const problem::Problem& problem, const problem::Scales& scales,
                        bool at_wall) {
  const double impulses = problem::impulses_per_decay_time(problem, scales);
  const double least =
      at_wall ? core_at_rest(scales.velocity_deviation, usual_speed_in_contact(problem, scales))
              : kLeastCore;
  return std::clamp(std::exp(-kNothingLeft / impulses), least, kMostCore);
}

bool at_wall(const Flow& flow, const RestPlace& place) {
  const auto is_at = [&](Side side) {
    return flow.wall(side) && flow.wall(side)->position == place.y;
  };
  return is_at(Side::left) || is_at(Side::right);
}

struct UsualLengths {
  double speed, core_v;
  std::vector<RestPlace> places;
  std::vector<double> core_y = {};  // for each rest point
  double widest = 0;  // largest distance from a rest point that the typical speed attains
};

UsualLengths usual_lengths(const problem::Problem& problem, const problem::Scales& scales,
                           const Flow& flow) {
  UsualLengths found{.speed = usual_speed_in_contact(problem, scales),
                     .core_v = kContactCore,
                     .places = rest_places(flow)};
  for (const RestPlace& place : found.places) {
    const Reach reach = flow.reach({place.y, found.speed});
    const double length = std::max(place.y - reach.low, reach.high - place.y);
    found.widest = std::max(found.widest, length);
    if (place.contact) {
      // The height of the first cell is that of a flight with the speed of the first cell.
      const double slow = kCellWidth * kContactCore * found.speed;
      const double height = slow * slow / (2 * std::abs(flow.force(place.y)));
      found.core_y.push_back(height / kCellWidth);
    } else {
      const double core = equilibrium_core(problem, scales, at_wall(flow, place));
      found.core_y.push_back(core * length);
      found.core_v = std::min(found.core_v, core);
    }
  }
  return found;
}

}  // namespace

Grid contact_grid(const problem::Problem& problem, const problem::Scales& scales,
                  const Options& options, const Box& box) {
  const Flow flow(problem.system);
  const UsualLengths scale = usual_lengths(problem, scales, flow);
  const double part = kCellWidth / options.refinement;
  double least = flow.potential(scale.places.front().y);
  for (const RestPlace& place : scale.places) least = std::min(least, flow.potential(place.y));
  std::vector<double> anchors{box.x1_min};
  for (const RestPlace& place : scale.places) {
    if (place.y > anchors.back() && place.y < box.x1_max) anchors.push_back(place.y);
  }
  anchors.push_back(box.x1_max);
  const auto width_in_y = [&](double y) {
    const double speed = std::sqrt(2 * std::max(0.0, flow.potential(y) - least));
    // Near a saddle the force is not a measure of the density's length scale.
    double nearest = scale.widest;
    for (const RestPlace& place : scale.places) {
      nearest = std::max(nearest, std::abs(y - place.y) / 4);
    }
    double inverse = std::max(
        1 / nearest, std::abs(flow.force(y)) / (std::max(speed, scale.speed) * scale.speed));
    for (std::size_t k = 0; k < scale.places.size(); ++k) {
      inverse += 1 / (scale.core_y[k] + std::abs(y - scale.places[k].y));
    }
    return part / inverse;
  };
  const std::vector<double> speeds{0, box.x2_max};
  const auto width_in_v = [&](double v) {
    return part / (1 / scale.speed + 1 / (scale.core_v * scale.speed + v));
  };
  const auto beyond = [&](Side side) {
    return flow.wall(side) ? Beyond::boundary : Beyond::vacuum;
  };
  return symmetric_grid(faces_by_width(anchors, width_in_y), faces_by_width(speeds, width_in_v),
                        beyond(Side::left), beyond(Side::right));
}

Box generous_contact_box(const problem::Problem& problem, const problem::Scales& scales,
                         const Options& options) {
  constexpr double kTimes = 5, kDeviations = 9, kHigher = 1.1;
  const Flow flow(problem.system);
  const auto& law = problem.impulses.law();
  Box box{.x1_max = 0,
          .x2_max = options.x2_max.value_or(kTimes * usual_speed_in_contact(problem, scales) +
                                            std::abs(law.mean()) + kDeviations * law.deviation())};
  double lowest = 0, highest = 0;
  for (const RestPlace& place : rest_places(flow)) {
    const Reach reach = flow.reach({place.y, box.x2_max});
    lowest = std::min(lowest, reach.low);
    highest = std::max(highest, reach.high);
  }
  const auto& left = flow.wall(Side::left);
  const auto& right = flow.wall(Side::right);
  box.x1_min = left ? left->position : kHigher * lowest;
  box.x1_max = right ? right->position : options.x1_max.value_or(kHigher * highest);
  return box;
}

}  // namespace fpkcheck::fd_fpk
