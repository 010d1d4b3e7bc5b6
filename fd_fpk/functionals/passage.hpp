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
/// for the survival probability T, or the first exit from the interval (a, b) between two barriers,
/// where also T(a, v) = 0 for v < 0. Under noise the equation is discretised by finite differences
/// (BarrierGrid). Under impulses alone, for the equations km4 and for impulse.factor, one barrier
/// is solved in a Krylov space of the transposed matrix of finite volumes, and two barriers by
/// finite differences. The stationary density of finite volumes gives the stationary initial
/// density and Rice's rate. The errors follow from three or more grids
/// (FunctionalValuesFromGridSequence).
/// @param barrier displacement barrier, or two displacement barriers, in physical coordinates
/// @param times times of the survival probabilities; automatic times if empty
/// @param start initial state of FirstPassageResult::mean_from_point; if empty, the initial state
/// is at rest
/// @throws InputError for invalid options
transform::FirstPassageResult solve_passage(const problem::Problem& problem,
                                            const FiniteVolumeOptions& options,
                                            const transform::PassageBarrier& barrier,
                                            std::vector<double> times,
                                            std::optional<transform::PassageStartState> start = {});

}  // namespace fpkcheck::fd_fpk
