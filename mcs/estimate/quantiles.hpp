#pragma once

#include <vector>

#include "mcs/estimate/stream_weights.hpp"
#include "mcs/simulation/simulation.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::mcs {

/// Quantiles of y or y' from the histogram's distribution function F, cubic between its edges. The
/// interval holds the values whose F differs from the probability by no more than chance explains
/// (Woodruff, JASA 47, 1952). Those that lie outside of the bins are left out.
std::vector<Quantile> estimate_quantiles(const Simulation& simulation, const StreamWeights& weights,
                                         transform::Variable variable);

}  // namespace fpkcheck::mcs
