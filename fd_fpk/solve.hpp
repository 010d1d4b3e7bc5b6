#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fd_fpk/options.hpp"
#include "fd_fpk/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Name and version of each library that solves linear systems or steps in time. The version is
/// that of the loaded shared library if the library has a function that returns its version,
/// otherwise the version of the headers.
std::vector<std::pair<std::string, std::string>> library_versions();

/// The stationary density of the (generalised) Fokker-Planck-Kolmogorov equation, paper (15), by
/// finite volumes on the point-symmetric half of the (z, z') plane. There are two discretisations
/// of the transport: finite volumes of high order with the exact impact map, and characteristics of
/// the motion, which are used if impulses are rare or losses are strong. If the options fix neither
/// transport nor grid, refine_until_deadline() chooses finer grids. If the status of the solution
/// with the first discretisation of the transport is not `ok`, the solver also computes the
/// solution with the other discretisation.
///
/// Status of the solution:
/// - `ok`: no reason for another status applies;
/// - `ill_posed`: the discrete excitation is unstable (the literal km4 on a fine grid), and no
///   density is computed;
/// - `inaccurate`: the estimated error exceeds the requested accuracy;
/// - `not_converged`: the stationarity residual exceeds its threshold;
/// - `inadmissible`: the density is negative, or the residual of its power balance exceeds the
///   limit for a resolved density (kStationaryLimits);
/// - `failed`: the box is too small, the grid is too large, or KLU fails. Under white noise the
///   status is `failed` also if impacts accumulate at the restitution coefficient
///   (problem/features.hpp).
/// @throws InputError for invalid options
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::fd_fpk
