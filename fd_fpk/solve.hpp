#pragma once

#include "fd_fpk/options.hpp"
#include "fd_fpk/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// The stationary density of the (generalised) Fokker-Planck-Kolmogorov equation, paper (15), by
/// finite volumes of high order on the point-symmetric half of the (z, z') plane with the exact
/// impact map.
///
/// Status: `ok`; `ill_posed` when the discrete excitation grows (the literal km4 on a fine grid: it
/// is not stepped); `not_converged` when the residual asked for is not reached; `inadmissible` when
/// the density is negative or misses the balance of power by more than a resolved one would;
/// `failed` when the box is too small, the grid would be too large or KLU breaks down, and for
/// white noise at a restitution at which impacts accumulate (problem/inelastic_collapse.hpp).
/// @throws InputError when the options cannot be used
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::fd_fpk
