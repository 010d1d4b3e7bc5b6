#pragma once

#include <fmt/format.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <cstdint>

#include "base/input_error.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::tests {

/// The random problem with this number from all supported oscillators, in any units:
///
///     restoring force  linear, hardening, bistable, tilted, of fifth degree, constant, or none
///                      between walls
///     damping          linear (.02 to 2 times the frequency), van der Pol, Rayleigh, both, or
///                      none if walls dissipate energy
///     walls            none, one on either side within three lengths of the origin, or two, with
///                      r from .2 to 1
///     excitation       impulses (rate .1 to 100 times the frequency, any law and mean), white
///                      noise, or both
inline problem::Problem random_oscillator(std::uint64_t number) {
  boost::random::mt19937_64 engine(number);
  boost::random::uniform_01<double> unit;
  const auto between = [&](double from, double to) { return from + (to - from) * unit(engine); };
  const auto log_between = [&](double from, double to) {
    return std::exp(between(std::log(from), std::log(to)));
  };
  const auto pick = [&](int count) { return static_cast<int>(count * unit(engine)); };
  for (;;) {
    const double frequency = log_between(0.05, 20), length = log_between(0.01, 100);
    const double k = frequency * frequency, c = frequency * log_between(0.02, 2);
    problem::SystemCoefficients system;
    switch (pick(6)) {
      case 0:
        system.stiffness = k;
        break;
      case 1:
        system.stiffness = k;
        system.cubic = k / (length * length) * log_between(0.05, 5);
        break;
      case 2:
        system.stiffness = -k;
        system.cubic = k / (length * length) * log_between(0.3, 3);
        break;
      case 3:
        system.constant = k * length * between(-0.3, 0.3);
        system.stiffness = k * between(-1, 1);
        system.quadratic = k / length * between(-0.5, 0.5);
        system.cubic = k / (length * length) * log_between(0.3, 3);
        break;
      case 4:
        system.stiffness = k * between(-1, 1);
        system.cubic = k / (length * length) * between(-1, 1);
        system.quintic = k / std::pow(length, 4) * log_between(0.2, 2);
        break;
      case 5:
        system.constant = k * length * between(-1, 1);
        break;
    }
    switch (pick(5)) {
      case 0:
      case 1:
        system.damping = c;
        break;
      case 2:
        system.damping = -c / 2;
        system.van_der_pol = c / (length * length);
        break;
      case 3:
        system.damping = c * between(-0.5, 0.5);
        system.rayleigh = c / (k * length * length) * log_between(0.1, 1);
        break;
      case 4:
        system.damping = 0;
        break;
    }
    problem::WallParameters walls;
    const int where = pick(4);
    const auto restitution = [&] { return unit(engine) < 0.2 ? 1 : between(0.2, 1); };
    walls.none = where == 0;
    if (where == 1 || where == 3) {
      walls.left = where == 3 ? -length * between(0.2, 3) : length * between(-3, 1);
      walls.left_restitution = restitution();
    }
    if (where == 2 || where == 3) {
      walls.right = where == 3 ? length * between(0.2, 3) : length * between(-1, 3);
      walls.right_restitution = restitution();
    }
    const double intensity = 2 * c * k * length * length * log_between(0.05, 2);
    const int excitation = pick(3);
    problem::ImpulseTrain impulses;
    problem::WhiteNoise noise;
    if (excitation != 1) {
      const char* const laws[] = {"gaussian", "laplace", "two_point", "uniform"};
      const double rate = frequency * log_between(0.1, 100);
      const double skew = unit(engine) < 0.5 ? 0 : between(-0.8, 0.8);
      impulses = problem::ImpulseTrain({.arrival_rate = rate,
                                        .law = laws[pick(4)],
                                        .intensity = intensity,
                                        .mean = skew * std::sqrt(intensity / rate)});
    }
    if (excitation != 0) noise.intensity = intensity * log_between(0.1, 1);
    try {
      problem::Problem problem{.name = fmt::format("member{}", number),
                               .system = problem::System(system, walls),
                               .impulses = impulses,
                               .noise = noise};
      problem::require_stationary_density(problem);
      return problem;
    } catch (const InputError&) {  // no stationary density: draw another problem
    }
  }
}

}  // namespace fpkcheck::tests
