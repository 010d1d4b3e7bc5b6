#pragma once

#include "fd_fpk/options.hpp"
#include "fd_fpk/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// The stationary density of the (generalised) Fokker-Planck-Kolmogorov equation, paper (15), by
/// finite volumes on the point-symmetric half of the (z, z') plane. Two transports: finite volumes
/// of high order with the exact impact map; characteristics of the motion, where impulses are rare
/// or losses are strong. Where the options fix neither transport nor grid, refine_until_deadline()
/// chooses finer grids, and the second transport is computed where the first is not `ok`.
///
/// Status:
/// - `ok`;
/// - `ill_posed`: the discrete excitation is unstable (the literal km4 on a fine grid); nothing is
///   solved;
/// - `inaccurate`: the estimated error exceeds the requested accuracy;
/// - `not_converged`: the residual exceeds its threshold;
/// - `inadmissible`: the density is negative, or its power balance has a residual above that of a
///   resolved density;
/// - `failed`: the box is too small, the grid too large or KLU fails; also white noise at a
///   restitution coefficient for which impacts accumulate (problem/inelastic_collapse.hpp).
/// @throws InputError for invalid options
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::fd_fpk
