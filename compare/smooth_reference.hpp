#pragma once

#include <span>
#include <vector>

#include "compare/pairs.hpp"
#include "transform/solution.hpp"

/// Comparison over smooth bins with a simulation with control variates: its averages have an error
/// of about 1e-6 in L1 and no discretisation error.
namespace fpkcheck::compare {

/// The simulation that serves as reference over smooth bins: status ok, equation `kf`, with smooth
/// estimates; null if there is none.
const transform::Solution* find_smooth_reference(std::span<const transform::Solution> solutions);

/// Marginals over the smooth bins of the reference simulation: its own estimates, and averages of
/// the other marginals. The averages of a density on cells are computed from its cells, which
/// resolve a spike, not from the bins of the axes, which do not.
/// @param sharp marginals on the comparison axes
/// @param solutions the solutions of these marginals
std::vector<SolutionMarginal> smooth_bin_marginals(std::span<const SolutionMarginal> sharp,
                                                   std::span<const transform::Solution> solutions,
                                                   const transform::Solution& smooth_reference);

/// Standard error of the L1 distance of a marginal from an estimate, to first order: the standard
/// error of sum_b s_b (a_b - p_b) w_b, where s_b is the sign of a_b - p_b.
/// @param a marginal over the bins of the estimate
double l1_standard_error(const transform::Marginal& a, const transform::SmoothEstimate& estimate);

}  // namespace fpkcheck::compare
