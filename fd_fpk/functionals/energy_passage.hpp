#pragma once

#include <optional>
#include <vector>

#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"
#include "transform/passage.hpp"

namespace fpkcheck::fd_fpk {

/// Computes the first passage of the energy v^2/2 + U(y) above a level H, from the backward
/// equation of the survival probability below the level (EnergyLevelGrid). The stationary density
/// on a grid of finite volumes gives the stationary initial density. The errors follow from three
/// or more grids (FunctionalValuesFromGridSequence). The result has no rate of upcrossings.
/// @param times times of the survival probabilities; automatic times if empty
/// @param start initial state of FirstPassageResult::mean_from_point; if empty, the initial state
/// is at rest
/// @throws InputError for invalid options
transform::FirstPassageResult solve_energy_passage(
    const problem::Problem& problem, const FiniteVolumeOptions& options, double energy,
    std::vector<double> times, std::optional<transform::PassageStartState> start = {});

}  // namespace fpkcheck::fd_fpk
