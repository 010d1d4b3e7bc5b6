#pragma once

#include <span>
#include <vector>

#include "compare/pair_distances.hpp"
#include "transform/solution.hpp"

/// Comparison over smooth bins (B-spline weights) of solutions with the smooth reference, which is
/// a simulation with control variates. The averages of the smooth reference over smooth bins have
/// an L1 error of about 1e-6 and no discretisation error.
namespace fpkcheck::compare {

/// Returns the smooth reference (the first `ok` simulation with the equation `kf` and smooth
/// estimates), or null.
const transform::Solution* find_smooth_reference(std::span<const transform::Solution> solutions);

/// Converts marginal densities to averages over the smooth bins of the smooth reference. For the
/// smooth reference the function returns its smooth estimates. For a density on a grid the averages
/// are computed from the grid cells, which resolve narrow peaks better than the comparison bins.
/// @param sharp marginal densities of the solutions over the comparison bins
std::vector<SolutionMarginalDensity> to_smooth_bin_marginals(
    std::span<const SolutionMarginalDensity> sharp, std::span<const transform::Solution> solutions,
    const transform::Solution& smooth_reference);

/// Returns the standard error, to first order, of the L1 distance of a marginal density a from a
/// smooth estimate p. The result is the standard error of sum_b s_b (a_b - p_b) w_b, with the width
/// w_b of bin b and the sign s_b of a_b - p_b.
/// @param a marginal density over the smooth bins of the estimate
double l1_standard_error(const transform::Marginal& a,
                         const transform::SmoothBinEstimate& estimate);

}  // namespace fpkcheck::compare
