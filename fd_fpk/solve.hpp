#pragma once

#include "fd_fpk/options.hpp"
#include "fd_fpk/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// The stationary density of the (generalised) Fokker-Planck-Kolmogorov equation, paper (15), by
/// finite volumes on the point-symmetric half of the (z, z') plane: of high order with the exact
/// impact map, or along the characteristics of the motion where impulses are rare or losses strong.
/// Where the options leave transport and grid free, finer grids follow as solve_within() does, and
/// the other transport is tried where the first is not `ok`.
///
/// Status: `ok`; `ill_posed` when the discrete excitation grows (the literal km4 on a fine grid: it
/// is not stepped); `inaccurate` when the estimated error is larger than the accuracy asked for;
/// `not_converged` when the residual asked for is not reached; `inadmissible` when
/// the density is negative or misses the balance of power by more than a resolved one would;
/// `failed` when the box is too small, the grid would be too large or KLU breaks down, and for
/// white noise at a restitution at which impacts accumulate (problem/inelastic_collapse.hpp).
/// @throws InputError when the options cannot be used
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::fd_fpk
