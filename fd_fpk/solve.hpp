#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fd_fpk/options.hpp"
#include "fd_fpk/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Returns name and version of each library that solves linear systems or steps in time. The
/// version is the version of the loaded library, or of the headers if the library has no version
/// function.
std::vector<std::pair<std::string, std::string>> library_versions();

/// Computes the stationary density p of the (generalised) Fokker-Planck-Kolmogorov equation, paper
/// (15). Beside a wall the domain is the half z >= 0 of the (z, z') plane, since p(-z, -z') =
/// p(z, z'). The transport is discretised by finite volumes of high order, or along characteristics
/// for rare impulses or strong losses. If the options fix neither transport nor grid,
/// refine_grid_until_deadline() chooses finer grids. Several threads solve on the three grids of an
/// error estimate and trace characteristics. If the first discretisation of the transport does not
/// give the status `ok`, the solver also tries the second discretisation.
///
/// The status is `ill_posed`, without a density, if the discrete excitation is unstable (the
/// literal km4 on a fine grid). The status is `inadmissible` if the density is negative or the
/// residual of the power balance is too large (check_resolution()). The status is `failed` if the
/// computational box is too small, the grid is too large, or KLU fails. Under white noise the
/// status is `failed` also if impacts accumulate at the restitution coefficient
/// (problem/problem_features.hpp).
/// @throws InputError for invalid options
FiniteVolumeResult solve_stationary_density(const problem::Problem& problem,
                                            const FiniteVolumeOptions& options);

}  // namespace fpkcheck::fd_fpk
