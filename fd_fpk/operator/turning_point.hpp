#pragma once

#include "problem/system.hpp"

namespace fpkcheck::fd_fpk {

/// The y > 0 at which all of an energy is potential, U(y) = energy: how far from the wall the mass
/// gets with it.
/// @param energy positive and finite
double turning_point(const problem::System& system, double energy);

}  // namespace fpkcheck::fd_fpk
