#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Requires the conditions under which a stationary density exists: an excitation, a restoring
/// force that confines the motion, and dissipation that exceeds the energy input at large energies
/// (EnergyAveraging).
/// @throws InputError that states which condition is violated and which parameters to change
void require_stationary_density(const Problem& problem);

}  // namespace fpkcheck::problem
