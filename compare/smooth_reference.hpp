#pragma once

#include <span>
#include <vector>

#include "compare/pair_distances.hpp"
#include "transform/solution.hpp"

/// Comparison of solutions with a simulation with control variates (the smooth reference) over
/// smooth bins (B-splines as weights). The averages over smooth bins by a simulation with control
/// variates have an L1 error of about 1e-6 and no discretisation error.
namespace fpkcheck::compare {

/// Returns the smooth reference, the first `ok` simulation of the equation `kf` that has estimates
/// over smooth bins, or null.
const transform::Solution* find_smooth_reference(std::span<const transform::Solution> solutions);

/// Converts marginal densities to averages over the smooth bins of the simulation
/// `smooth_reference`. For the simulation `smooth_reference` the function returns the simulated
/// averages over smooth bins. For a density on a grid the averages over smooth bins are computed
/// from the grid cells, which resolve narrow peaks better than the comparison bins.
/// @param sharp marginal densities over the comparison bins
std::vector<SolutionMarginalDensity> to_smooth_bin_marginals(
    std::span<const SolutionMarginalDensity> sharp, std::span<const transform::Solution> solutions,
    const transform::Solution& smooth_reference);

/// Returns the standard error, to first order, of the L1 distance of a marginal density a from a
/// simulated density p over smooth bins. The standard error of the L1 distance is that of sum_b s_b
/// (a_b - p_b) w_b, with the width w_b of bin b and the sign s_b of a_b - p_b.
/// @param a marginal density over the smooth bins of the estimate
double l1_standard_error(const transform::Marginal& a,
                         const transform::SmoothBinEstimate& estimate);

}  // namespace fpkcheck::compare
