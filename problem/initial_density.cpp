#include "problem/initial_density.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/input_error.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::problem {
namespace {

constexpr double kReachedDeviations = 6;

// Returns the largest energy v^2/2 + V(y) between the walls, on the ellipse at kReachedDeviations
// standard deviations from the mean of the initial density.
double max_initial_energy(const System& system, const EffectivePotential& potential,
                          const InitialGaussian& start) {
  constexpr int kDirections = 120;
  double most = -HUGE_VAL;
  for (int n = 0; n < kDirections; ++n) {
    const double angle = 2 * std::numbers::pi * n / kDirections;
    double y = start.mean_displacement +
               kReachedDeviations * start.displacement_deviation * std::cos(angle);
    if (system.left_wall()) y = std::max(y, system.left_wall()->position);
    if (system.right_wall()) y = std::min(y, system.right_wall()->position);
    const double v =
        start.mean_velocity + kReachedDeviations * start.velocity_deviation * std::sin(angle);
    most = std::max(most, v * v / 2 + potential(y));
  }
  return most;
}

}  // namespace

InitialGaussian initial_density(const Problem& problem, const MotionScales& scales,
                                const InitialDensityOptions& options) {
  constexpr double kDefault = 0.5;
  InitialGaussian start{
      .displacement_deviation =
          options.displacement_deviation.value_or(kDefault * scales.displacement_deviation),
      .velocity_deviation =
          options.velocity_deviation.value_or(kDefault * scales.velocity_deviation),
      .mean_displacement = has_equivalent_linearisation(problem) ? 0 : scales.centre};
  // Rounding errors of the mean displacement 0 in a symmetric potential well are removed.
  constexpr double kRounding = 1e-12;
  if (std::abs(start.mean_displacement) < kRounding * start.displacement_deviation) {
    start.mean_displacement = 0;
  }
  const WallFrame& frame = problem.frame;
  if (const auto& y = options.mean_displacement)
    start.mean_displacement = frame.wall_coordinate(*y);
  if (const auto& v = options.mean_velocity) start.mean_velocity = frame.physical_velocity(*v);
  const auto &left = problem.system.left_wall(), &right = problem.system.right_wall();
  if ((left && start.mean_displacement < left->position) ||
      (right && start.mean_displacement > right->position)) {
    throw InputError(
        fmt::format("start-mean-y = {:.6g}: behind a wall; choose a value between the walls",
                    frame.physical_y(start.mean_displacement)));
  }
  return start;
}

StateRange reachable_state_range(const Problem& problem, const InitialGaussian& density) {
  const UndampedOrbits orbits(problem);
  const double energy = max_initial_energy(problem.system, orbits.potential(), density);
  const auto half_cycles = orbits.half_cycles(energy);
  return {half_cycles.front().left, half_cycles.back().right,
          std::sqrt(2 * (energy - orbits.lowest_potential()))};
}

}  // namespace fpkcheck::problem
