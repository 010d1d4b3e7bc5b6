#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Refuses what has no stationary density, by name: no excitation, a spring that does not hold, or
/// energy that is not taken out again (EnergyAveraging).
/// @throws InputError saying which, and what to change
void require_stationary(const Problem& problem);

}  // namespace fpkcheck::problem
