#include "problem/motion_scales.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "problem/energy_averaging.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::problem {
namespace {

// Distance from the mean to the ends of the motion, in standard deviations: 7 standard deviations
// from the mean, a Gaussian density is exp(-7^2/2) times its peak.
constexpr double kDeviations = 7;

MotionScales scales_from_linearisation(const Problem& problem) {
  const auto linear = equivalent_linearisation(problem);
  const double centre = static_deflection(problem);
  return {.centre = centre,
          .displacement_deviation = linear.displacement_deviation,
          .velocity_deviation = linear.velocity_deviation,
          .y_low = 0,
          .y_high = centre + kDeviations * linear.displacement_deviation,
          .v_high = kDeviations * linear.velocity_deviation,
          .frequency = std::sqrt(linear.stiffness),
          .slowest_decay_rate = slowest_decay_rate(linear)};
}

// Returns the smallest positive eigenvalue of the overdamped motion, discretised on a uniform grid
// of displacements. Far above critical damping the drift of the displacement is v = -V'/c, and the
// displacement is a diffusion process with the coefficient D_eff / c^2 in the potential c V /
// D_eff.
double overdamped_relaxation_rate(const Problem& problem, const MotionScales& scales,
                                  double damping) {
  constexpr std::size_t kCells = 200;
  const double diffusion = total_excitation_intensity(problem) / 2;
  const EffectivePotential potential(problem);
  const double step = (scales.y_high - scales.y_low) / kCells;
  const double over = diffusion / (damping * damping) / (step * step);
  std::vector<double> level(kCells), y(kCells);
  for (std::size_t n = 0; n < kCells; ++n) {
    y[n] = scales.y_low + (static_cast<double>(n) + 0.5) * step;
    level[n] = damping / diffusion * potential(y[n]);
  }
  const double least = *std::ranges::min_element(level);
  double total = 0;
  for (const double one : level) total += std::exp(least - one);
  EnergyDiffusionTree chain;
  for (std::size_t n = 0; n < kCells; ++n) {
    const std::size_t next = std::min(n + 1, kCells - 1);
    chain.mass.push_back(std::exp(least - level[n]) / total);
    chain.conductance.push_back(over * std::exp(least - (level[n] + level[next]) / 2) / total);
    chain.parent.push_back(next);
  }
  return slowest_relaxation_rate(chain, std::move(y));
}

}  // namespace

MotionScales scales_from_energy_averaging(const Problem& problem,
                                          const EnergyAveraging& averaging) {
  constexpr double kLevel = kDeviations * kDeviations / 2;
  const auto& bands = averaging.energy_bands();
  const double bottom = averaging.undamped_orbits().lowest_potential();
  MotionScales scales;
  double y2 = 0, v2 = 0, damping = 0, lowest = bands.front().orbit.half_cycle.left,
         highest = bands.front().orbit.half_cycle.right;
  for (const auto& band : bands) {
    const OrbitIntegrals& orbit = band.orbit;
    const double rate = band.mass / orbit.period;
    scales.centre += rate * orbit.time_integral_y;
    y2 += rate * orbit.time_integral_y2;
    v2 += rate * orbit.action;  // the closed integral of v dy is T times the mean of v^2
    damping += rate * orbit.time_integral_damping;
    scales.frequency += rate * 2 * std::numbers::pi;
    if (band.potential > kLevel) continue;
    lowest = std::min(lowest, orbit.half_cycle.left);
    highest = std::max(highest, orbit.half_cycle.right);
    scales.v_high = std::max(scales.v_high, std::sqrt(2 * (band.energy - bottom)));
  }
  scales.displacement_deviation =
      std::sqrt(std::max(y2 - scales.centre * scales.centre, 1e-24 * y2));
  scales.velocity_deviation = std::sqrt(v2);
  scales.y_low = lowest;
  scales.y_high = highest;
  // The decay rate of the amplitude is half of the decay rate of the energy.
  scales.slowest_decay_rate = averaging.relaxation_rate() / 2;
  if (damping > 0) {
    scales.slowest_decay_rate =
        std::min(scales.slowest_decay_rate, overdamped_relaxation_rate(problem, scales, damping));
  }
  return scales;
}

MotionScales motion_scales(const Problem& problem) {
  return has_equivalent_linearisation(problem)
             ? scales_from_linearisation(problem)
             : scales_from_energy_averaging(problem, EnergyAveraging(problem));
}

double decayed_fraction(const MotionScales& scales, double time) {
  return -std::expm1(-scales.slowest_decay_rate * time);
}

double impulses_per_decay_time(const Problem& problem, const MotionScales& scales) {
  return problem.impulses.arrival_rate() / scales.slowest_decay_rate;
}

}  // namespace fpkcheck::problem
