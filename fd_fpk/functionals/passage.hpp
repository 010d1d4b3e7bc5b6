#pragma once

#include <optional>
#include <vector>

#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"
#include "transform/passage.hpp"

namespace fpkcheck::fd_fpk {

/// Computes the first passage of y above a barrier b from the backward equation on y < b,
///
///     dT/dt = L* T,   T(b, v) = 0 for v > 0,   T(0, -u) = T(0, r u),
///
/// for the survival probability T, in a Krylov space of the transposed matrix of finite volumes.
/// Motion that crosses the barrier is absorbed. The stationary density, computed on the same cells
/// and on further cells beyond the barrier, gives the stationary initial density and Rice's rate.
/// The errors follow from three or more grids (FunctionalValuesFromGridSequence).
/// @param times times of the survival probabilities; automatic times if empty
/// @param start initial state of FirstPassageResult::mean_from_point; if empty, the initial state
/// is at rest
/// @throws InputError for invalid options
transform::FirstPassageResult solve_passage(const problem::Problem& problem,
                                            const FiniteVolumeOptions& options, double barrier,
                                            std::vector<double> times,
                                            std::optional<transform::PassageStartState> start = {});

}  // namespace fpkcheck::fd_fpk
