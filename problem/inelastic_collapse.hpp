#pragma once

#include <string>

#include "problem/model.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// exp(-pi / sqrt 3): under white noise a particle that keeps no more than this of its speed makes
/// infinitely many impacts in a finite time and comes to rest on the wall (inelastic collapse; S. J.
/// Cornell, M. R. Swift, A. J. Bray, Phys. Rev. Lett. 81, 1142 (1998)). How it leaves the wall again
/// is then a law of its own, which neither the equation nor the impact states.
inline constexpr double kCollapseRestitution = 0.16303353482158048;

/// Why equation and impact do not determine a stationary density at one of the walls and what to
/// do; empty where they do. Impulses come one by one and part the particle from the wall: it
/// collapses under the problem's own noise, whatever the equation, and where `white` takes them for
/// noise.
std::string collapse_objection(const Problem& problem, Equation equation);

}  // namespace fpkcheck::problem
