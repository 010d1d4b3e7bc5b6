#pragma once

#include <vector>

#include "mcs/estimate/stream_weights.hpp"
#include "mcs/simulation/simulation.hpp"

namespace fpkcheck::mcs {

/// Rates of upward crossings of levels of y. The rate is the number of maxima above the level minus
/// the number of minima above the level, per unit time. Between an upward crossing and the next
/// downward crossing y has one maximum more than minima above the level. The minima at the wall are
/// below all levels. Every tenth bin edge of y is a level, from the first edge above the wall.
std::vector<LevelEventRate> estimate_upcrossing_rates(const Simulation& simulation,
                                                      const StreamWeights& weights);

/// Rates of maxima of y above 0 and above the levels of estimate_upcrossing_rates(). The ratio of
/// such a rate to the rate above 0 is the probability that a peak exceeds the level.
std::vector<LevelEventRate> estimate_peak_rates(const Simulation& simulation,
                                                const StreamWeights& weights);

}  // namespace fpkcheck::mcs
