#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fd_fpk/options.hpp"
#include "fd_fpk/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Returns name and version of each library for linear systems or time integration. The returned
/// version is that of the loaded library, or of the headers if the library has no version function.
std::vector<std::pair<std::string, std::string>> library_versions();

/// Computes the stationary density p of the (generalised) Fokker-Planck-Kolmogorov equation, paper
/// (15). For an oscillator with one wall the equation is solved on the half z >= 0 of the (z, z')
/// plane, since p(-z, -z') = p(z, z'). The transport of the density is discretised by finite
/// volumes of high order, or along characteristics for rare impulses or strong losses. If the
/// options fix neither the transport scheme nor the grid, refine_grid_until_deadline() chooses
/// finer grids. Several threads solve on the three grids of an error estimate and trace
/// characteristics. If the solution with one transport scheme does not have the status `ok`, the
/// solver also tries the other transport scheme.
///
/// The status of the solution is `ill_posed`, without a density, if the discrete excitation is
/// unstable (the literal scheme of the Kramers-Moyal equation `km4` on a fine grid). The status of
/// the solution is `inadmissible` if the density is negative or the residual of the power balance
/// is too large (check_resolution()). The status of the solution is `failed` if the computational
/// box is too small, the grid is too large, or KLU fails. Under white noise the status is `failed`
/// also if impacts accumulate at the restitution coefficient (problem/problem_features.hpp).
/// @throws InputError for invalid options
FiniteVolumeResult solve_stationary_density(const problem::Problem& problem,
                                            const FiniteVolumeOptions& options);

}  // namespace fpkcheck::fd_fpk
