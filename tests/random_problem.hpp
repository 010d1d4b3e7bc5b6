#pragma once

#include <fmt/format.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <cstdint>

#include "problem/problem.hpp"

namespace fpkcheck::tests {

/// The random problem with this number, of the paper's oscillator, in any units. The damping is .01
/// to 5 and the rate .02 to 300 times the frequency, and r is .05 to 1. Half of the problems have a
/// cubic stiffness, whose force at a deviation is up to 100 times the linear force; one in twenty
/// has no linear stiffness. The law is any of four; half of the problems have a mean up to .95 of
/// the root of E[Y^2].
inline problem::Problem random_problem(std::uint64_t number) {
  boost::random::mt19937_64 engine(number);
  boost::random::uniform_01<double> unit;
  const auto between = [&](double from, double to) { return from + (to - from) * unit(engine); };
  const auto log_between = [&](double from, double to) {
    return std::exp(between(std::log(from), std::log(to)));
  };
  const double frequency = log_between(0.05, 20);
  const double length = log_between(0.01, 100);
  const double damping = frequency * log_between(0.01, 5);
  const double rate = frequency * log_between(0.02, 300);
  const double restitution = unit(engine) < 0.1 ? 1 : between(0.05, 1);
  const double hardening = unit(engine) < 0.5 ? 0 : log_between(0.01, 100);
  const bool spring = hardening == 0 || unit(engine) > 0.1;
  const char* const laws[] = {"gaussian", "laplace", "two_point", "uniform"};
  const char* const law = laws[static_cast<int>(4 * unit(engine))];
  const double stiffness = frequency * frequency;
  const double intensity = 2 * damping * stiffness * length * length;
  const double skew = unit(engine) < 0.5 ? 0 : between(-0.95, 0.95);
  return {.name = fmt::format("random{}", number),
          .system = problem::System({.damping = damping,
                                     .stiffness = spring ? stiffness : 0,
                                     .cubic = hardening * stiffness / (length * length),
                                     .restitution = restitution}),
          .impulses = problem::ImpulseTrain({.arrival_rate = rate,
                                             .law = law,
                                             .intensity = intensity,
                                             .mean = skew * std::sqrt(intensity / rate)})};
}

}  // namespace fpkcheck::tests
