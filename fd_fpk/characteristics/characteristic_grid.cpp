#include "fd_fpk/characteristics/characteristic_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/characteristics/deterministic_motion.hpp"
#include "fd_fpk/characteristics/rest_points.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

constexpr double kCellWidth = 0.2;  // cell width far from rest points, in typical amplitudes
// Distance from a singularity of the density other than the origin over which the cell widths
// decrease, in units of the typical amplitude.
constexpr double kSpikeReach = 0.25;
constexpr double kSpikeCore = 0.005;

// Returns the mean acceleration towards the wall due to impulses of nonzero mean amplitude.
double mean_acceleration_to_wall(const problem::Problem& problem) {
  return std::max(0.0, -problem.impulses.rate_times_moment(1));
}

// Returns the standard deviation of the speed, also for short flights between impacts under a mean
// acceleration G towards the wall. In the power balance for the speed v, the input power D2 of the
// impulses equals the dissipated power c v^2 + (1 - r^2) G v / 4, with the damping coefficient c
// and the restitution coefficient r.
double speed_deviation(const problem::Problem& problem) {
  const double linear = problem::equivalent_linearisation(problem).velocity_deviation;
  const double r = problem.system.restitution(), c = problem.system.damping();
  const double loss = (1 - r * r) * mean_acceleration_to_wall(problem) / 8;
  const double d2 = problem.impulses.intensity() / 2;
  const double bouncing = d2 / (loss + std::sqrt(loss * loss + c * d2));
  return std::min(linear, bouncing);
}

double typical_speed(const problem::Problem& problem, double deviation) {
  return std::max(deviation, 0.5 * std::sqrt(problem.impulses.amplitude_law().moment(2)));
}

double typical_height(const problem::Problem& problem, const DeterministicFlow& flow,
                      double speed) {
  const double bounce = mean_acceleration_to_wall(problem) > 0
                            ? speed * speed / (2 * mean_acceleration_to_wall(problem))
                            : std::numeric_limits<double>::infinity();
  return std::min(flow.half_cycle(speed).height, bounce);
}

// Returns the value that the absolute impulse amplitude |Y| exceeds with the given probability.
double impulse_quantile(const problem::ImpulseLaw& law, double probability) {
  double amplitude = std::sqrt(law.moment(2));
  while (1 - law.cumulative_probability(amplitude) + law.cumulative_probability(-amplitude) >
         probability) {
    amplitude *= 1.05;
  }
  return amplitude;
}

// Amplitudes and speeds of the motion at which the density has a spike or a discontinuity.
struct DensitySingularities {
  std::vector<double> y, v;
};

// Returns the amplitudes and speeds at which the density has spikes and discontinuities. An atom of
// the impulse law moves mass at rest to a single speed. The stationary density has spikes at
// turning points and impact speeds of the characteristic whose start speed is the amplitude of an
// atom. An impulse law whose density begins with a step causes a discontinuity of the stationary
// density at the speed of the step.
DensitySingularities density_singularities(const problem::Problem& problem,
                                           const DeterministicFlow& flow, double typical_speed) {
  constexpr int kHalfCycles = 6;
  constexpr double kFaint = 0.02, kSlow = 0.02, kApart = 0.9, kStep = 1e-3;
  const auto& law = problem.impulses.amplitude_law();
  DensitySingularities found;
  for (const auto& [amplitude, probability] : law.amplitude_atoms()) {
    double speed = amplitude > 0 ? amplitude : -problem.system.restitution() * amplitude;
    double left = 1;
    found.v.push_back(std::abs(amplitude));
    for (int n = 0; n < kHalfCycles && left > kFaint && speed > kSlow * typical_speed; ++n) {
      const HalfCycle half_cycle = flow.half_cycle(speed);
      found.y.push_back(half_cycle.height);
      found.v.push_back(speed);
      found.v.push_back(half_cycle.impact_speed);
      // Density spikes of half-cycles with nearly equal amplitudes are not resolved separately.
      const double next = problem.system.restitution() * half_cycle.impact_speed;
      if (next > kApart * speed) break;
      speed = next;
      left *= std::exp(-problem.impulses.arrival_rate() * half_cycle.duration);
    }
  }
  const double deviation = law.amplitude_standard_deviation(), inside = 1e-6 * deviation;
  for (const double end : law.amplitude_density_breakpoints()) {
    const double step = std::abs(law.density(end + inside) - law.density(end - inside));
    if (step * deviation > kStep) found.v.push_back(std::abs(end));
  }
  return found;
}

// Returns the origin and the singularities of the density as refinement points of an axis, without
// nearly coincident points.
std::vector<RefinementPoint> refinement_points(double typical, double core,
                                               std::vector<double> singular) {
  const CellGrading to_spike{.reach = kSpikeReach * typical, .core = kSpikeCore * typical};
  std::vector<RefinementPoint> refinement_points{{0, {.reach = typical, .core = core * typical}}};
  std::ranges::sort(singular);
  for (const double x : singular) {
    if (x > refinement_points.back().x + 2 * to_spike.core)
      refinement_points.push_back({x, to_spike});
  }
  return refinement_points;
}

PhasePlaneGrid grid_from_linearised_scales(const problem::Problem& problem,
                                           const FiniteVolumeOptions& options,
                                           const PhasePlaneBox& box) {
  const DeterministicFlow flow(problem.system);
  const double deviation = speed_deviation(problem), v = typical_speed(problem, deviation);
  const double y = typical_height(problem, flow, v);
  const double width = kCellWidth / options.refinement;
  const double core = uniform_cell_radius_at_rest_point(deviation, v);
  // An impulse of fixed amplitude (an atom of the law) displaces the density spike of mass at rest
  // without widening the spike.
  const DensitySingularities singular = is_density_unbounded_at_origin(problem)
                                            ? density_singularities(problem, flow, v)
                                            : DensitySingularities{};
  return symmetric_grid(
      cell_faces_graded_to_points(0, box.x1_max, width * y, refinement_points(y, core, singular.y)),
      cell_faces_graded_to_points(0, box.x2_max, width * v,
                                  refinement_points(v, core, singular.v)));
}

PhasePlaneBox initial_box_from_linearised_scales(const problem::Problem& problem,
                                                 const FiniteVolumeOptions& options) {
  constexpr double kTimes = 10, kImpulses = 1.5, kHigher = 1.2, kRare = 1e-8;
  // Under a constant force towards the wall, the largest displacement is proportional to the square
  // of the largest speed.
  constexpr double kTimesPressed = 5;
  const double times = mean_acceleration_to_wall(problem) > 0 ? kTimesPressed : kTimes;
  const double v_max = options.x2_max.value_or(
      times * typical_speed(problem, speed_deviation(problem)) +
      kImpulses * impulse_quantile(problem.impulses.amplitude_law(), kRare));
  double y_max = kHigher * typical_height(problem, DeterministicFlow(problem.system), v_max);
  if (mean_acceleration_to_wall(problem) == 0) {
    const auto linear = problem::equivalent_linearisation(problem);
    y_max = std::max(y_max,
                     problem::static_deflection(problem) + kTimes * linear.displacement_deviation);
  }
  return {.x1_max = options.x1_max.value_or(y_max), .x2_max = v_max};
}

// Speed, in typical speeds, below which impacts at a rest point in contact count as a cascade
constexpr double kContactCore = 0.02;
// Limits of the distance to an equilibrium, in typical amplitudes, below which cells have a
// constant width: kLeastCore for rare impulses, kMostCore for frequent impulses. Around an
// equilibrium between walls, the discretisation errors on opposite sides of the equilibrium cancel
// in the mean. Towards an equilibrium at a wall the cell widths decrease further, to
// uniform_cell_radius_at_rest_point().
constexpr double kLeastCore = 1e-3, kMostCore = 0.1, kNothingLeft = 40;

// Returns the typical distance to an equilibrium after the decay of motion between two impulses.
double equilibrium_core_distance(const problem::Problem& problem,
                                 const problem::MotionScales& scales, bool is_at_wall) {
  const double impulses = problem::impulses_per_decay_time(problem, scales);
  const double least =
      is_at_wall ? uniform_cell_radius_at_rest_point(
                       scales.velocity_deviation, typical_speed(problem, scales.velocity_deviation))
                 : kLeastCore;
  return std::clamp(std::exp(-kNothingLeft / impulses), least, kMostCore);
}

bool is_at_wall(const DeterministicFlow& flow, const RestPoint& point) {
  const auto is_at = [&](WallSide side) {
    return flow.wall(side) && flow.wall(side)->position == point.y;
  };
  return is_at(WallSide::left) || is_at(WallSide::right);
}

// Factors of the cell widths for motion along a limit cycle. For 3*(y^2-1)*v + y under impulses of
// rate 1 and intensity 0.5 the estimated L1 error of p(y) within the default time limit is 0.008
// with the factors 0.3 for y and 1.5 for v, 0.012 with the factors 0.5 and 1.5, and 0.041 with the
// factors 0.5 and 1.
constexpr double kLimitCycleFactorY = 0.3, kLimitCycleFactorV = 1.5;

// Returns the displacements of all rest points, or of the equilibria that a limit cycle encloses.
std::vector<double> centres_of_motion(const DeterministicFlow& flow) {
  std::vector<double> centres;
  for (const RestPoint& point : find_rest_points(flow)) centres.push_back(point.y);
  return centres.empty() ? flow.potential_extrema() : centres;
}

struct TypicalMotionScales {
  double speed, core_v;
  std::vector<RestPoint> points;
  std::vector<double> core_y = {};  // CellGrading::core in y, for each rest point
  // Largest distance from a rest point that motion with the typical speed attains
  double widest = 0;
  double least_potential = 0;
};

TypicalMotionScales typical_scales(const problem::Problem& problem,
                                   const problem::MotionScales& scales,
                                   const DeterministicFlow& flow) {
  TypicalMotionScales found{.speed = typical_speed(problem, scales.velocity_deviation),
                            .core_v = kContactCore,
                            .points = find_rest_points(flow)};
  const std::vector<double> centres = centres_of_motion(flow);
  found.least_potential = flow.potential_energy(centres.front());
  const auto distance_from = [&](double y) {
    const AccessibleDisplacements accessible_displacements =
        flow.accessible_displacements({y, found.speed});
    return std::max(y - accessible_displacements.low, accessible_displacements.high - y);
  };
  for (const double y : centres) {
    found.widest = std::max(found.widest, distance_from(y));
    found.least_potential = std::min(found.least_potential, flow.potential_energy(y));
  }
  for (const RestPoint& point : found.points) {
    const double length = distance_from(point.y);
    if (point.contact) {
      // The first cell in the displacement y is as wide as the height of a flight whose initial
      // speed is the width of the first cell in the velocity v.
      const double slow = kCellWidth * kContactCore * found.speed;
      const double height = slow * slow / (2 * std::abs(flow.static_force(point.y)));
      found.core_y.push_back(height / kCellWidth);
    } else {
      const double core = equilibrium_core_distance(problem, scales, is_at_wall(flow, point));
      found.core_y.push_back(core * length);
      found.core_v = std::min(found.core_v, core);
    }
  }
  return found;
}

PhasePlaneGrid grid_from_rest_points(const problem::Problem& problem,
                                     const problem::MotionScales& scales,
                                     const FiniteVolumeOptions& options, const PhasePlaneBox& box) {
  const DeterministicFlow flow(problem.system);
  const TypicalMotionScales scale = typical_scales(problem, scales, flow);
  const double part = kCellWidth / options.refinement;
  const bool has_limit_cycle = scale.points.empty();
  const double part_y = part * (has_limit_cycle ? kLimitCycleFactorY : 1);
  const double part_v = part * (has_limit_cycle ? kLimitCycleFactorV : 1);
  std::vector<double> anchors{box.x1_min};
  for (const RestPoint& point : scale.points) {
    if (point.y > anchors.back() && point.y < box.x1_max) anchors.push_back(point.y);
  }
  anchors.push_back(box.x1_max);
  const auto width_in_y = [&](double y) {
    const double speed =
        std::sqrt(2 * std::max(0.0, flow.potential_energy(y) - scale.least_potential));
    // Near a saddle point of the motion the force does not determine the length scale of the
    // density.
    double nearest = scale.widest;
    for (const RestPoint& point : scale.points) {
      nearest = std::max(nearest, std::abs(y - point.y) / 4);
    }
    double inverse = std::max(
        1 / nearest, std::abs(flow.static_force(y)) / (std::max(speed, scale.speed) * scale.speed));
    for (std::size_t k = 0; k < scale.points.size(); ++k) {
      inverse += 1 / (scale.core_y[k] + std::abs(y - scale.points[k].y));
    }
    return part_y / inverse;
  };
  const std::vector<double> speeds{0, box.x2_max};
  const auto width_in_v = [&](double v) {
    return part_v / (1 / scale.speed + 1 / (scale.core_v * scale.speed + v));
  };
  const auto beyond = [&](WallSide side) {
    return flow.wall(side) ? AxisEndCondition::boundary : AxisEndCondition::vacuum;
  };
  return symmetric_grid(cell_faces_from_width_function(anchors, width_in_y),
                        cell_faces_from_width_function(speeds, width_in_v), beyond(WallSide::left),
                        beyond(WallSide::right));
}

PhasePlaneBox initial_box_from_rest_points(const problem::Problem& problem,
                                           const problem::MotionScales& scales,
                                           const FiniteVolumeOptions& options) {
  constexpr double kTimes = 5, kDeviations = 9, kHigher = 1.1;
  const DeterministicFlow flow(problem.system);
  const auto& law = problem.impulses.amplitude_law();
  PhasePlaneBox box{.x1_max = 0,
                    .x2_max = options.x2_max.value_or(
                        kTimes * typical_speed(problem, scales.velocity_deviation) +
                        std::abs(law.mean()) + kDeviations * law.amplitude_standard_deviation())};
  const auto& left = flow.wall(WallSide::left);
  const auto& right = flow.wall(WallSide::right);
  double highest = 0;
  for (const double y : centres_of_motion(flow)) {
    const AccessibleDisplacements accessible_displacements =
        flow.accessible_displacements({y, box.x2_max});
    highest = std::max(highest, accessible_displacements.high);
    if (!left) highest = std::max(highest, -accessible_displacements.low);
  }
  box.x1_max = right ? right->position : options.x1_max.value_or(kHigher * highest);
  box.x1_min = left ? left->position : -box.x1_max;
  return box;
}

}  // namespace

PhasePlaneGrid characteristic_grid(const problem::Problem& problem,
                                   const problem::MotionScales& scales,
                                   const FiniteVolumeOptions& options, const PhasePlaneBox& box) {
  return has_linearised_scales(problem) ? grid_from_linearised_scales(problem, options, box)
                                        : grid_from_rest_points(problem, scales, options, box);
}

PhasePlaneBox initial_characteristic_box(const problem::Problem& problem,
                                         const problem::MotionScales& scales,
                                         const FiniteVolumeOptions& options) {
  return has_linearised_scales(problem) ? initial_box_from_linearised_scales(problem, options)
                                        : initial_box_from_rest_points(problem, scales, options);
}

}  // namespace fpkcheck::fd_fpk
