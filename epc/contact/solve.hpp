#pragma once

#include "epc/options.hpp"
#include "epc/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::contact {

/// Solves the closure of a mass that comes to rest in contact with a wall: a density
/// C exp(Q_n(rho, v) + confinement) / e and the atom that belongs to it (Coordinates), whose
/// coefficients meet the exact equations for the means of the functions of the basis.
/// @pre applies(problem)
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::contact
