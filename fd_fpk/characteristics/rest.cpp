#include "fd_fpk/characteristics/rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpkcheck::fd_fpk {
namespace {

// The force on the mass towards the wall.
double pressing(const Flow& flow, Side side) {
  return inwards(side) * flow.force(flow.wall(side)->position);
}

// One small half-cycle from the wall, up to the next impact or until the motion is overdamped: the
// fraction of the time with v < 0, weighted by exp(-rate t), and the impact rate.
struct SmallMotion {
  double share_below;
  double impact_rate;
};
SmallMotion small_motion(const Flow& flow, Side side, double speed, double rate) {
  constexpr double kAtRest = 1e-6;
  constexpr int kFiner = 10;  // factor by which steps are shortened
  constexpr long kMostSteps = 20000;
  const double wall = flow.wall(side)->position;
  const SmallMotion creeping{.share_below = side == Side::left ? 1.0 : 0.0, .impact_rate = 0};
  State state{wall, inwards(side) * speed};
  const double least = flow.potential(wall);
  double below = 0, time = 0;
  for (long step = 0; step < kMostSteps; ++step) {
    const double left = flow.energy(state) - least;
    if (left < kAtRest * kAtRest * speed * speed / 2) return creeping;
    double span = flow.longest_step(state, flow.reach(state)) / kFiner;
    State end = flow.after(state, span);
    const bool impact = flow.beyond(end.y) == side;
    if (impact) {
      span = flow.impact_time(state, span, side);
      end = {wall, flow.after(state, span).v};
    }
    if (state.v + end.v < 0) {
      below += std::exp(-rate * time) * -std::expm1(-rate * span);
    }
    time += span;
    if (impact) {
      return {.share_below = below / -std::expm1(-rate * time), .impact_rate = 1 / time};
    }
    state = end;
  }
  return creeping;
}

// The columns of cells next to y: one where y is a wall, two where y is a face between cells.
std::vector<int> columns_at(const Line& line, double y) {
  std::vector<int> columns;
  for (int i = 0; i < line.cells(); ++i) {
    if (line.face(i) <= y && y <= line.face(i + 1)) columns.push_back(i);
  }
  return columns;
}

void find_cells(const Flow& flow, const Grid& grid, double rate, RestPlace& place) {
  const int middle = grid.nv() / 2;
  const double v = grid.x2.face(middle + 1);
  const auto columns = columns_at(grid.x1, place.y);
  const double low = grid.x1.face(columns.front()), high = grid.x1.face(columns.back() + 1);
  const auto cell = [&](int i, int j) { return i * grid.nv() + j; };
  // The least energy on the boundary of the cells, except for walls.
  place.least_energy = flow.potential(place.y) + v * v / 2;
  for (const double end : {low, high}) {
    if (end != place.y) place.least_energy = std::min(place.least_energy, flow.potential(end));
  }
  const auto at_wall = [&]() -> std::optional<Side> {
    for (const Side side : {Side::left, Side::right}) {
      if (flow.wall(side) && flow.wall(side)->position == place.y) return side;
    }
    return std::nullopt;
  }();
  double below = 0.5;
  if (at_wall && !place.contact) {
    constexpr double kSmall = 0.1;
    const auto motion = small_motion(flow, *at_wall, kSmall * v, rate);
    below = motion.share_below;
    place.impact_rate = motion.impact_rate;
  }
  for (const int i : columns) {
    const double part = grid.x1.width(i) / (high - low);
    place.cells.push_back({cell(i, middle - 1), below * part});
    place.cells.push_back({cell(i, middle), (1 - below) * part});
  }
}

}  // namespace

std::vector<RestPlace> rest_places(const Flow& flow) {
  std::vector<RestPlace> places;
  const auto& turns = flow.turns();
  const auto at_wall = [&](Side side) {
    if (!flow.wall(side)) return;
    const double wall = flow.wall(side)->position, g = pressing(flow, side);
    // For a wall at an equilibrium the potential half way to the next extremum determines
    // stability.
    const double beside = side == Side::left ? (turns.empty() ? wall + 1 : turns.front())
                                             : (turns.empty() ? wall - 1 : turns.back());
    const bool stable =
        g > 0 || (g == 0 && flow.potential((wall + beside) / 2) > flow.potential(wall));
    if (!stable) return;
    RestPlace place{.y = wall};
    if (g > 0 && flow.wall(side)->restitution < 1) place.contact = side;
    places.push_back(place);
  };
  at_wall(Side::left);
  for (const double turn : turns) {
    // A minimum of U: g changes sign from - to +.
    const double next = [&] {
      for (const double other : turns) {
        if (other > turn) return other;
      }
      return flow.wall(Side::right) ? flow.wall(Side::right)->position : turn + 1;
    }();
    if (flow.force((turn + next) / 2) > 0) places.push_back({.y = turn});
  }
  at_wall(Side::right);
  return places;
}

std::vector<RestPlace> rest_places(const Flow& flow, const Grid& grid, double rate) {
  auto places = rest_places(flow);
  for (RestPlace& place : places) find_cells(flow, grid, rate, place);
  return places;
}

double core_at_rest(double deviation, double usual_amplitude) {
  constexpr double kCore = 1e-3;
  const double ratio = std::min(1.0, deviation / usual_amplitude);
  return kCore * ratio * ratio;
}

Cascade cascade(double speed, double pressing, double restitution, double rate) {
  const double r = restitution;
  return {.survival = std::exp(-rate * 2 * speed / (pressing * (1 - r))),
          .momentum = speed / (1 - r),
          .energy = speed * speed / (1 - r * r)};
}

}  // namespace fpkcheck::fd_fpk
