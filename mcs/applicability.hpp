#pragma once

#include <string>

#include "mcs/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {

/// Whether the fast motion (Oscillator, MotionParameters) simulates a problem; otherwise
/// GeneralMotionParameters does. The step limit of the fast motion requires that the energy does
/// not grow between impulses: constant damping c > 0, no noise, and a force k y + mu y^3 with
/// k, mu >= 0. Its impacts require a single wall, at the equilibrium y = 0.
bool has_energy_bounded_flights(const problem::Problem& problem);

/// The reason why the simulation does not support a problem with these options, in one phrase.
/// Empty if the problem is supported.
std::string unsupported_reason(const problem::Problem& problem, const Options& options);

/// The reason why importance splitting does not resolve the tails of the density if the
/// energy also rises between impulses. Empty if the energy rises at impulses only.
std::string unsupported_splitting_reason(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::mcs
