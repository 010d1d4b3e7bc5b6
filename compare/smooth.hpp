#pragma once

#include <span>
#include <vector>

#include "compare/pairs.hpp"
#include "transform/solution.hpp"

/// Measuring in smooth bins: by a simulation from which the noise was taken, which knows the
/// density there to about 1e-6 in L1 and owes nothing to any discretisation.
namespace fpkcheck::compare {

/// The simulation that all others are measured by: ok, of the jumps, with smooth estimates; null
/// where there is none.
const transform::Solution* smooth_measure(std::span<const transform::Solution> solutions);

/// The marginals of one variable in the measure's smooth bins: its own estimate, and the averages
/// of all others. Those of a density on cells come from its cells, which are narrow where it has a
/// spike, and not from the axes' bins, in which the spike is lost.
/// @param sharp on the comparison axes
/// @param solutions that they are of
std::vector<SolutionMarginal> in_smooth_bins(std::span<const SolutionMarginal> sharp,
                                             std::span<const transform::Solution> solutions,
                                             const transform::Solution& measure);

/// Standard error of the L1 distance of a marginal from an estimate, to first order: that of
/// sum +-(a_b - p_b) w_b with the signs of the differences.
/// @param a in the estimate's bins
double l1_standard_error(const transform::Marginal& a, const transform::SmoothEstimate& estimate);

}  // namespace fpkcheck::compare
