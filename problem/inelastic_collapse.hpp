#pragma once

#include <string>

#include "problem/model.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// exp(-pi / sqrt 3): up to this restitution a particle under white noise makes infinitely many
/// impacts in a finite time and comes to rest on the wall (inelastic collapse; S. J. Cornell, M. R.
/// Swift, A. J. Bray, Phys. Rev. Lett. 81, 1142 (1998)). How the particle leaves the wall again is
/// an additional law, which neither the equation nor the impact condition states.
inline constexpr double kCollapseRestitution = 0.16303353482158048;

/// The reason why equation and impact condition do not determine a stationary density at one of the
/// walls, and how to avoid it; empty where they do. Discrete impulses separate the particle from
/// the wall. Collapse therefore occurs under the problem's own noise, for every equation, and under
/// `white`, which replaces the impulses by noise.
std::string collapse_unsupported_reason(const Problem& problem, Equation equation);

}  // namespace fpkcheck::problem
