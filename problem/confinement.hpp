#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Requires that a stationary density exists: excitation, a restoring force that confines the
/// motion, and dissipation that prevails at large energies (EnergyAveraging).
/// @throws InputError naming the condition that fails, and what to change
void require_stationary_density(const Problem& problem);

}  // namespace fpkcheck::problem
