#pragma once

#include <span>
#include <vector>

#include "compare/pair_distances.hpp"
#include "transform/solution.hpp"

/// Comparison of solutions over smooth bins with the smooth reference, a simulation with control
/// variates. The averages of the smooth reference over smooth bins have an L1 error of about 1e-6
/// and no discretisation error.
namespace fpkcheck::compare {

/// The first simulation with the status ok, the equation `kf` and smooth estimates. This simulation
/// is the reference over smooth bins. Null if there is none.
const transform::Solution* find_smooth_reference(std::span<const transform::Solution> solutions);

/// Converts marginals to averages over the smooth bins of the smooth reference. The marginals of
/// the smooth reference are replaced by its smooth estimates. For a density on a grid the averages
/// are computed from the cells of the grid. The cells resolve a spike of the density, while the
/// bins of the comparison axes do not.
/// @param sharp marginals on the comparison axes
/// @param solutions solutions to which the marginals belong
std::vector<SolutionMarginal> smooth_bin_marginals(std::span<const SolutionMarginal> sharp,
                                                   std::span<const transform::Solution> solutions,
                                                   const transform::Solution& smooth_reference);

/// Standard error of the L1 distance of a marginal a from a smooth estimate p, to first order: the
/// standard error of sum_b s_b (a_b - p_b) w_b, where w_b is the width of bin b and s_b is the sign
/// of a_b - p_b.
/// @param a marginal over the bins of the estimate
double l1_standard_error(const transform::Marginal& a,
                         const transform::SmoothBinEstimate& estimate);

}  // namespace fpkcheck::compare
