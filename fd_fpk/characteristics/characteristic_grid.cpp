#include "fd_fpk/characteristics/characteristic_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fd_fpk/characteristics/flow.hpp"
#include "fd_fpk/characteristics/rest_points.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

constexpr double kWidth = 0.2;  // cell width far from the origin, in typical amplitudes
// Parameters of the grading towards singularities other than the origin: over shorter distances
// than towards the origin.
constexpr double kSpikeReach = 0.25;
constexpr double kSpikeCore = 0.005;

// Mean acceleration towards the wall due to impulses of nonzero mean.
double mean_acceleration_to_wall(const problem::Problem& problem) {
  return std::max(0.0, -problem.impulses.rate_times_moment(1));
}

// With a mean acceleration G towards the wall the oscillator makes short flights between impacts.
// The oscillator meets the wall G / (2 v) times per unit time, and the input power D2 of the
// impulses equals the dissipated power c v^2 + (1 - r^2) G v / 4.
double speed_deviation(const problem::Problem& problem) {
  const double linear = problem::equivalent_linearisation(problem).velocity_deviation;
  const double r = problem.system.restitution(), c = problem.system.damping();
  const double loss = (1 - r * r) * mean_acceleration_to_wall(problem) / 8;
  const double d2 = problem.impulses.intensity() / 2;
  const double bouncing = d2 / (loss + std::sqrt(loss * loss + c * d2));
  return std::min(linear, bouncing);
}

double typical_speed(const problem::Problem& problem) {
  return std::max(speed_deviation(problem), 0.5 * std::sqrt(problem.impulses.law().moment(2)));
}

double typical_height(const problem::Problem& problem, const Flow& flow, double speed) {
  const double bounce = mean_acceleration_to_wall(problem) > 0
                            ? speed * speed / (2 * mean_acceleration_to_wall(problem))
                            : std::numeric_limits<double>::infinity();
  return std::min(flow.half_cycle(speed).height, bounce);
}

// The amplitude that the impulse |Y| exceeds with this probability.
double impulse_quantile(const problem::ImpulseLaw& law, double probability) {
  double amplitude = std::sqrt(law.moment(2));
  while (1 - law.cumulative_probability(amplitude) + law.cumulative_probability(-amplitude) >
         probability) {
    amplitude *= 1.05;
  }
  return amplitude;
}

// Amplitudes and speeds at which the density has a spike, as at the rest point, or a discontinuity.
struct Singularities {
  std::vector<double> y, v;
};

// An atom of the impulse law moves mass at rest to a single speed. The characteristic from this
// speed has turning points and impacts, at whose heights and speeds the density has spikes. A law
// whose density begins with a step causes a discontinuity of the density at the speed of that step.
Singularities singularities(const problem::Problem& problem, const Flow& flow,
                            double typical_speed) {
  constexpr int kHalfCycles = 6;
  constexpr double kFaint = 0.02, kSlow = 0.02, kApart = 0.9, kStep = 1e-3;
  const auto& law = problem.impulses.law();
  Singularities found;
  for (const auto& [amplitude, probability] : law.atoms()) {
    double speed = amplitude > 0 ? amplitude : -problem.system.restitution() * amplitude;
    double left = 1;
    found.v.push_back(std::abs(amplitude));
    for (int n = 0; n < kHalfCycles && left > kFaint && speed > kSlow * typical_speed; ++n) {
      const HalfCycle half_cycle = flow.half_cycle(speed);
      found.y.push_back(half_cycle.height);
      found.v.push_back(speed);
      found.v.push_back(half_cycle.impact_speed);
      // The spikes of half-cycles with nearly equal amplitudes are not separate.
      const double next = problem.system.restitution() * half_cycle.impact_speed;
      if (next > kApart * speed) break;
      speed = next;
      left *= std::exp(-problem.impulses.arrival_rate() * half_cycle.duration);
    }
  }
  const double deviation = law.deviation(), inside = 1e-6 * deviation;
  for (const double end : law.density_breakpoints()) {
    const double step = std::abs(law.density(end + inside) - law.density(end - inside));
    if (step * deviation > kStep) found.v.push_back(std::abs(end));
  }
  return found;
}

// Refinement points at the origin and at the other singularities. Of points that nearly coincide
// only one is returned.
std::vector<RefinementPoint> refinement_points(double typical, double core,
                                               std::vector<double> singular) {
  const Grading to_spike{.reach = kSpikeReach * typical, .core = kSpikeCore * typical};
  std::vector<RefinementPoint> refinement_points{{0, {.reach = typical, .core = core * typical}}};
  std::ranges::sort(singular);
  for (const double x : singular) {
    if (x > refinement_points.back().x + 2 * to_spike.core)
      refinement_points.push_back({x, to_spike});
  }
  return refinement_points;
}

}  // namespace

Grid characteristic_grid(const problem::Problem& problem, const Options& options, const Box& box) {
  const Flow flow(problem.system);
  const double v = typical_speed(problem), y = typical_height(problem, flow, v);
  const double width = kWidth / options.refinement;
  const double core = relative_core_width(speed_deviation(problem), v);
  // An impulse displaces the spike of mass at rest without making it wider.
  const Singularities singular =
      is_unbounded_at_origin(problem) ? singularities(problem, flow, v) : Singularities{};
  return symmetric_grid(
      faces_graded_to_points(0, box.x1_max, width * y, refinement_points(y, core, singular.y)),
      faces_graded_to_points(0, box.x2_max, width * v, refinement_points(v, core, singular.v)));
}

Box initial_characteristic_box(const problem::Problem& problem, const Options& options) {
  constexpr double kTimes = 10, kImpulses = 1.5, kHigher = 1.2, kRare = 1e-8;
  // With a constant force the height of the box, and so the number of cells, is proportional to the
  // square of the speed.
  constexpr double kTimesPressed = 5;
  const double times = mean_acceleration_to_wall(problem) > 0 ? kTimesPressed : kTimes;
  const double v_max = options.x2_max.value_or(
      times * typical_speed(problem) + kImpulses * impulse_quantile(problem.impulses.law(), kRare));
  double y_max = kHigher * typical_height(problem, Flow(problem.system), v_max);
  if (mean_acceleration_to_wall(problem) == 0) {
    const auto linear = problem::equivalent_linearisation(problem);
    y_max = std::max(y_max,
                     problem::static_deflection(problem) + kTimes * linear.displacement_deviation);
  }
  return {.x1_max = options.x1_max.value_or(y_max), .x2_max = v_max};
}

}  // namespace fpkcheck::fd_fpk
