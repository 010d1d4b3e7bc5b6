#pragma once

#include <vector>

#include "mcs/estimate/stream_weights.hpp"
#include "mcs/simulation/simulation.hpp"

namespace fpkcheck::mcs {

/// Upward crossings of levels of y per unit time: maxima above the level less minima above it
/// (between two crossings upwards there is one maximum more than minima, and all minima at the wall
/// lie below). The levels are every tenth edge of the bins of y, from the first one above the wall.
std::vector<LevelRate> estimate_crossings(const Simulation& simulation,
                                          const StreamWeights& weights);

/// Maxima of y per unit time above the same levels, and above 0 first: their ratios are the
/// exceedance probabilities of a peak.
std::vector<LevelRate> estimate_peaks(const Simulation& simulation, const StreamWeights& weights);

}  // namespace fpkcheck::mcs
