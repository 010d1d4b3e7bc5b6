#pragma once

#include "epc/options.hpp"
#include "epc/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::contact {

/// Solves the closure for a mass that comes to rest in contact with a wall. The solution is a
/// density C exp(Q_n(rho, v) + confinement) / e with an atom, see Coordinates. The coefficients of
/// Q_n satisfy the exact equations for the means of the basis functions.
/// @pre is_pressed_on_one_wall(problem)
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::contact
