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
/// The motion through the barrier leaves, and nothing returns. The stationary density on the same
/// cells, continued beyond the barrier, gives the stationary start and Rice's rate. The errors
/// follow from three or more grids (ConvergedValues).
/// @param times times of the survival probabilities; automatic times if empty
/// @param start start of Passage::mean_from_point; empty for a start at rest
/// @throws InputError for invalid options
transform::Passage solve_passage(const problem::Problem& problem, const Options& options,
                                 double barrier, std::vector<double> times,
                                 std::optional<transform::StartState> start = {});

}  // namespace fpkcheck::fd_fpk
