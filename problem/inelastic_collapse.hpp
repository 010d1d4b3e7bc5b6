#pragma once

#include <string>

#include "problem/model.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// The critical restitution coefficient exp(-pi / sqrt 3). For restitution coefficients up to this
/// value, a particle under white noise makes infinitely many impacts in a finite time and comes to
/// rest on the wall (inelastic collapse; S. J. Cornell, M. R. Swift, A. J. Bray, Phys. Rev. Lett.
/// 81, 1142 (1998)). The law by which the particle leaves the wall again is determined neither by
/// the equation nor by the impact condition.
inline constexpr double kCollapseRestitution = 0.16303353482158048;

/// Explains why the equation and the impact condition at one of the walls leave the stationary
/// density undetermined, and which change of the problem helps. Empty if the density is determined.
/// Discrete impulses separate the particle from the wall, so that inelastic collapse needs white
/// noise: the noise of the problem, for every equation; or the noise by which the equation `white`
/// replaces the impulses.
std::string inelastic_collapse_reason(const Problem& problem, Equation equation);

}  // namespace fpkcheck::problem
