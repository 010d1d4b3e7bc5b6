#include "fd_fpk/characteristics/rest_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpkcheck::fd_fpk {
namespace {

// Returns the force on the mass at rest at a wall, positive towards the wall.
double force_towards_wall(const DeterministicFlow& flow, WallSide side) {
  return inward_sign(side) * flow.static_force(flow.wall(side)->position);
}

// Half-cycle of small amplitude from the wall, up to the next impact or until the motion is
// overdamped. In the fraction of the time with negative velocity, each time t is weighted by
// exp(-impulse_rate t).
struct SmallAmplitudeHalfCycle {
  double fraction_below;
  double impact_rate;
};
SmallAmplitudeHalfCycle small_half_cycle(const DeterministicFlow& flow, WallSide side, double speed,
                                         double impulse_rate) {
  constexpr double kAtRest = 1e-6;
  constexpr int kFiner = 10;  // factor by which the time steps are shortened
  constexpr long kMostSteps = 20000;
  const double wall = flow.wall(side)->position;
  const SmallAmplitudeHalfCycle creeping{.fraction_below = side == WallSide::left ? 1.0 : 0.0,
                                         .impact_rate = 0};
  PhaseState state{wall, inward_sign(side) * speed};
  const double least = flow.potential_energy(wall);
  double below = 0, time = 0;
  for (long step = 0; step < kMostSteps; ++step) {
    const double left = flow.mechanical_energy(state) - least;
    if (left < kAtRest * kAtRest * speed * speed / 2) return creeping;
    double span = flow.max_time_step(state, flow.accessible_displacements(state)) / kFiner;
    PhaseState end = flow.advance_state(state, span);
    const bool impact = flow.wall_passed_by_displacement(end.y) == side;
    if (impact) {
      span = flow.impact_time(state, span, side);
      end = {wall, flow.advance_state(state, span).v};
    }
    if (state.v + end.v < 0) {
      below += std::exp(-impulse_rate * time) * -std::expm1(-impulse_rate * span);
    }
    time += span;
    if (impact) {
      return {.fraction_below = below / -std::expm1(-impulse_rate * time), .impact_rate = 1 / time};
    }
    state = end;
  }
  return creeping;
}

// Returns the columns of grid cells next to the displacement y: one column if y is at a wall, two
// columns if y is a face between cells.
std::vector<int> cell_columns_at(const GridAxis& axis, double y) {
  std::vector<int> columns;
  for (int i = 0; i < axis.cell_count(); ++i) {
    if (axis.face_position(i) <= y && y <= axis.face_position(i + 1)) columns.push_back(i);
  }
  return columns;
}

void assign_innermost_cells(const DeterministicFlow& flow, const PhasePlaneGrid& grid,
                            double impulse_rate, RestPoint& point) {
  const int middle = grid.v_cell_count() / 2;
  const double v = grid.x2.face_position(middle + 1);
  const auto columns = cell_columns_at(grid.x1, point.y);
  const double low = grid.x1.face_position(columns.front()),
               high = grid.x1.face_position(columns.back() + 1);
  const auto cell = [&](int i, int j) { return i * grid.v_cell_count() + j; };
  // The escape energy is the smallest energy on the boundary of the innermost cells of an
  // equilibrium, except on walls.
  point.escape_energy = flow.potential_energy(point.y) + v * v / 2;
  for (const double end : {low, high}) {
    if (end != point.y)
      point.escape_energy = std::min(point.escape_energy, flow.potential_energy(end));
  }
  const auto at_wall = [&]() -> std::optional<WallSide> {
    for (const WallSide side : {WallSide::left, WallSide::right}) {
      if (flow.wall(side) && flow.wall(side)->position == point.y) return side;
    }
    return std::nullopt;
  }();
  double below = 0.5;
  if (at_wall && !point.contact) {
    constexpr double kSmall = 0.1;
    const auto motion = small_half_cycle(flow, *at_wall, kSmall * v, impulse_rate);
    below = motion.fraction_below;
    point.impact_rate = motion.impact_rate;
  }
  for (const int i : columns) {
    const double part = grid.x1.cell_width(i) / (high - low);
    point.cells.push_back({cell(i, middle - 1), below * part});
    point.cells.push_back({cell(i, middle), (1 - below) * part});
  }
}

}  // namespace

std::vector<RestPoint> find_rest_points(const DeterministicFlow& flow) {
  std::vector<RestPoint> points;
  const auto& potential_extrema = flow.potential_extrema();
  const auto at_wall = [&](WallSide side) {
    if (!flow.wall(side)) return;
    const double wall = flow.wall(side)->position, g = force_towards_wall(flow, side);
    // The potential half way to the next extremum determines the stability of an equilibrium at a
    // wall.
    const double beside = side == WallSide::left
                              ? (potential_extrema.empty() ? wall + 1 : potential_extrema.front())
                              : (potential_extrema.empty() ? wall - 1 : potential_extrema.back());
    const bool stable = g > 0 || (g == 0 && flow.potential_energy((wall + beside) / 2) >
                                                flow.potential_energy(wall));
    if (!stable) return;
    RestPoint point{.y = wall};
    if (g > 0 && flow.wall(side)->restitution < 1) point.contact = side;
    points.push_back(point);
  };
  at_wall(WallSide::left);
  for (const double turn : potential_extrema) {
    // At a minimum of the potential the restoring force g changes sign from - to +.
    const double next = [&] {
      for (const double other : potential_extrema) {
        if (other > turn) return other;
      }
      return flow.wall(WallSide::right) ? flow.wall(WallSide::right)->position : turn + 1;
    }();
    const bool repels = flow.contraction_rate({turn, 0}) < 0;
    if (flow.static_force((turn + next) / 2) > 0 && !repels) points.push_back({.y = turn});
  }
  at_wall(WallSide::right);
  return points;
}

std::vector<RestPoint> find_rest_points(const DeterministicFlow& flow, const PhasePlaneGrid& grid,
                                        double impulse_rate) {
  auto points = find_rest_points(flow);
  for (RestPoint& point : points) assign_innermost_cells(flow, grid, impulse_rate, point);
  return points;
}

namespace {

// Returns the mean contraction rate along the limit cycle to which the motion tends.
double contraction_rate_of_limit_cycle(const DeterministicFlow& flow) {
  constexpr int kTransient = 10, kCycles = 10;
  constexpr long kMostSteps = 100000;
  const double centre = flow.potential_extrema().empty() ? 0 : flow.potential_extrema().front();
  PhaseState state{centre, 1};
  double contracted = 0, time = 0;
  int cycles = 0;
  for (long step = 0; step < kMostSteps && cycles < kTransient + kCycles; ++step) {
    const double span = flow.max_time_step(state, flow.accessible_displacements(state));
    const PhaseState end = flow.advance_state(state, span);
    if (state.v <= 0 && end.v > 0) ++cycles;
    if (cycles >= kTransient) {
      contracted += span * (flow.contraction_rate(state) + flow.contraction_rate(end)) / 2;
      time += span;
    }
    state = end;
  }
  return time > 0 ? contracted / time : 0;
}

}  // namespace

double contraction_rate_of_attractors(const DeterministicFlow& flow) {
  const auto points = find_rest_points(flow);
  if (points.empty()) return contraction_rate_of_limit_cycle(flow);
  double largest = 0;
  for (const RestPoint& point : points) {
    if (!point.contact) largest = std::max(largest, flow.contraction_rate({point.y, 0}));
  }
  return largest;
}

double uniform_cell_radius_at_rest_point(double deviation, double typical_amplitude) {
  constexpr double kCore = 1e-3;
  const double ratio = std::min(1.0, deviation / typical_amplitude);
  return kCore * ratio * ratio;
}

ImpactCascade impact_cascade(double speed, double force_towards_wall, double restitution,
                             double impulse_rate) {
  const double r = restitution;
  return {.rest_probability = std::exp(-impulse_rate * 2 * speed / (force_towards_wall * (1 - r))),
          .momentum = speed / (1 - r),
          .energy = speed * speed / (1 - r * r)};
}

}  // namespace fpkcheck::fd_fpk
