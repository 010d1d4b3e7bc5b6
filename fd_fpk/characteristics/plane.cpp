#include "fd_fpk/characteristics/plane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fd_fpk/characteristics/flow.hpp"
#include "fd_fpk/characteristics/rest.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

constexpr double kWidth = 0.2;  // width of cells far out, in typical amplitudes
// Grading towards other singularities, over shorter distances.
constexpr double kSpikeReach = 0.25;
constexpr double kSpikeCore = 0.005;

// Acceleration towards the wall due to the mean of the impulses.
double pressing(const problem::Problem& problem) {
  return std::max(0.0, -problem.impulses.rate_moment(1));
}

// With a mean acceleration G towards the wall the oscillator makes short flights between impacts.
// It meets the wall G / 2 v times per unit time, and the input power D2 of the impulses equals c
// v^2 + (1 - r^2) G v / 4.
double deviation_of_speed(const problem::Problem& problem) {
  const double linear = problem::equivalent_linearisation(problem).velocity_deviation;
  const double r = problem.system.restitution(), c = problem.system.damping();
  const double loss = (1 - r * r) * pressing(problem) / 8;
  const double d2 = problem.impulses.intensity() / 2;
  const double bouncing = d2 / (loss + std::sqrt(loss * loss + c * d2));
  return std::min(linear, bouncing);
}

double usual_speed(const problem::Problem& problem) {
  return std::max(deviation_of_speed(problem), 0.5 * std::sqrt(problem.impulses.law().moment(2)));
}

double usual_height(const problem::Problem& problem, const Flow& flow, double speed) {
  const double bounce = pressing(problem) > 0 ? speed * speed / (2 * pressing(problem))
                                              : std::numeric_limits<double>::infinity();
  return std::min(flow.winding(speed).height, bounce);
}

// The amplitude that |Y| exceeds with this probability.
double largest_impulse(const problem::ImpulseLaw& law, double probability) {
  double amplitude = std::sqrt(law.moment(2));
  while (1 - law.cumulative(amplitude) + law.cumulative(-amplitude) > probability) {
    amplitude *= 1.05;
  }
  return amplitude;
}

// Amplitudes and speeds at which the density is as singular as at rest, or discontinuous.
struct Singularities {
  std::vector<double> y, v;
};

// An atom of the law takes mass at rest to a known speed. Its characteristic has turning points at
// known heights and impacts at known speeds. A law that begins with a step causes a discontinuity
// at the speed of that step.
Singularities singularities(const problem::Problem& problem, const Flow& flow, double usual_speed) {
  constexpr int kWindings = 6;
  constexpr double kFaint = 0.02, kSlow = 0.02, kApart = 0.9, kStep = 1e-3;
  const auto& law = problem.impulses.law();
  Singularities found;
  for (const auto& [amplitude, probability] : law.atoms()) {
    double speed = amplitude > 0 ? amplitude : -problem.system.restitution() * amplitude;
    double left = 1;
    found.v.push_back(std::abs(amplitude));
    for (int n = 0; n < kWindings && left > kFaint && speed > kSlow * usual_speed; ++n) {
      const Winding winding = flow.winding(speed);
      found.y.push_back(winding.height);
      found.v.push_back(speed);
      found.v.push_back(winding.landing);
      // Half-cycles with nearly equal amplitudes cause no separate spikes.
      const double next = problem.system.restitution() * winding.landing;
      if (next > kApart * speed) break;
      speed = next;
      left *= std::exp(-problem.impulses.arrival_rate() * winding.duration);
    }
  }
  const double deviation = law.deviation(), inside = 1e-6 * deviation;
  for (const double end : law.smooth_pieces()) {
    const double step = std::abs(law.density(end + inside) - law.density(end - inside));
    if (step * deviation > kStep) found.v.push_back(std::abs(end));
  }
  return found;
}

// Refinement points at the origin and at the other singularities, without near duplicates.
std::vector<Centre> centres(double usual, double core, std::vector<double> singular) {
  const Grading to_spike{.reach = kSpikeReach * usual, .core = kSpikeCore * usual};
  std::vector<Centre> centres{{0, {.reach = usual, .core = core * usual}}};
  std::ranges::sort(singular);
  for (const double x : singular) {
    if (x > centres.back().x + 2 * to_spike.core) centres.push_back({x, to_spike});
  }
  return centres;
}

}  // namespace

Grid characteristic_grid(const problem::Problem& problem, const Options& options, const Box& box) {
  const Flow flow(problem.system);
  const double v = usual_speed(problem), y = usual_height(problem, flow, v);
  const double width = kWidth / options.refinement;
  const double core = core_at_rest(deviation_of_speed(problem), v);
  // The spike at rest is equally sharp after an impulse.
  const Singularities singular =
      unbounded_at_origin(problem) ? singularities(problem, flow, v) : Singularities{};
  return symmetric_grid(faces_graded_to(0, box.x1_max, width * y, centres(y, core, singular.y)),
                        faces_graded_to(0, box.x2_max, width * v, centres(v, core, singular.v)));
}

Box generous_box(const problem::Problem& problem, const Options& options) {
  constexpr double kTimes = 10, kImpulses = 1.5, kHigher = 1.2, kRare = 1e-8;
  // In a constant field the height of the box is proportional to the square of the speed, as is the
  // number of cells.
  constexpr double kTimesPressed = 5;
  const double times = pressing(problem) > 0 ? kTimesPressed : kTimes;
  const double v_max = options.x2_max.value_or(
      times * usual_speed(problem) + kImpulses * largest_impulse(problem.impulses.law(), kRare));
  double y_max = kHigher * usual_height(problem, Flow(problem.system), v_max);
  if (pressing(problem) == 0) {
    const auto linear = problem::equivalent_linearisation(problem);
    y_max = std::max(y_max,
                     problem::static_deflection(problem) + kTimes * linear.displacement_deviation);
  }
  return {.x1_max = options.x1_max.value_or(y_max), .x2_max = v_max};
}

}  // namespace fpkcheck::fd_fpk
