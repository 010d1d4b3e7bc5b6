#include "mcs/simulation/initial_state_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mcs/impulses/uniform_numbers.hpp"

namespace fpkcheck::mcs {

OscillatorState folded_initial_state(const ImpulseSource& source, double displacement_deviation,
                                     double velocity_deviation) {
  const auto normals = source.initial_standard_normals();
  const double z = displacement_deviation * normals[0];
  const double z_dot = velocity_deviation * normals[1];
  return {std::abs(z), std::copysign(1.0, z) * z_dot};
}

InitialStateSampler::InitialStateSampler(const problem::Problem& problem) : averaging_(problem) {
  double sum = 0;
  for (const auto& band : averaging_.energy_bands()) below_.push_back(sum += band.mass);
}

OscillatorState InitialStateSampler::operator()(std::uint64_t seed, std::uint32_t stream) const {
  const UniformRandomNumbers u =
      uniform_random_numbers(seed, stream, RandomNumberPurpose::start, kImpulsesPerBlock);
  const auto index = std::ranges::upper_bound(below_, u.first[0] * below_.back()) - below_.begin();
  const auto& bands = averaging_.energy_bands();
  const auto& band = bands[std::min(static_cast<std::size_t>(index), bands.size() - 1)];
  const auto [left, right, at_left, at_right] = band.orbit.half_cycle;
  const double middle = (left + right) / 2, half = (right - left) / 2;
  const problem::EffectivePotential& potential = averaging_.undamped_orbits().potential();
  const auto speed = [&](double y) {
    return std::sqrt(std::max(2 * (band.energy - potential(y)), 0.0));
  };
  // Rejection sampling draws the angle from a density proportional to half cos(angle) / speed, i.e.
  // to the residence time of the orbit at y = middle + half sin(angle).
  const auto time = [&](double angle) {
    const double v = speed(middle + half * std::sin(angle));
    return v > 0 ? half * std::cos(angle) / v : 0.0;
  };
  constexpr int kGridPoints = 64;
  const auto angle_of = [](double share) { return (share - 0.5) * std::numbers::pi; };
  double longest = 0;
  for (int n = 0; n < kGridPoints; ++n) {
    longest = std::max(longest, time(angle_of((n + 0.5) / kGridPoints)));
  }
  // Safety factor for maxima of the residence-time density between the grid points of the angle
  constexpr double kMargin = 1.2;
  double angle = 0;
  for (std::size_t k = 1; k < kImpulsesPerBlock; ++k) {
    angle = angle_of(u.first[k]);
    if (u.second[k] * kMargin * longest < time(angle)) break;
  }
  const double y = middle + half * std::sin(angle);
  return {y, u.third[0] < 0.5 ? -speed(y) : speed(y)};
}

}  // namespace fpkcheck::mcs
