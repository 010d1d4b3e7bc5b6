#pragma once

#include <vector>

#include "mcs/estimate/stream_weights.hpp"
#include "mcs/simulation/simulation.hpp"

namespace fpkcheck::mcs {

/// Rates of upward crossings of levels of y: maxima above the level less minima above the level,
/// per unit time. Between two upward crossings there is one maximum more than minima, and all
/// minima at the wall are below the level. The levels are every tenth bin edge of y, from the first
/// above the wall.
std::vector<LevelRate> estimate_crossings(const Simulation& simulation,
                                          const StreamWeights& weights);

/// Rates of maxima of y above 0 and above the same levels. Their ratios are the exceedance
/// probabilities of a peak.
std::vector<LevelRate> estimate_peaks(const Simulation& simulation, const StreamWeights& weights);

}  // namespace fpkcheck::mcs
