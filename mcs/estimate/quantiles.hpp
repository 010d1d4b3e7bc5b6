#pragma once

#include <vector>

#include "mcs/estimate/stream_weights.hpp"
#include "mcs/simulation/simulation.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::mcs {

/// Quantiles of y or y' from the distribution function F of the histogram, cubic between its edges.
/// The 95 % interval holds the values whose F agrees with the probability within the sampling error
/// (Woodruff, JASA 47, 1952). Quantiles outside the bins are omitted.
std::vector<Quantile> estimate_quantiles(const Simulation& simulation, const StreamWeights& weights,
                                         transform::Variable variable);

}  // namespace fpkcheck::mcs
