#pragma once

#include <vector>

#include "mcs/estimate/stream_weights.hpp"
#include "mcs/simulation/simulation.hpp"
#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::mcs {

/// Mean of y^p y'^q in one stream, (p, q) among kPowers, in wall coordinates.
double moment(const Simulation& simulation, const StreamRecord& record, int p, int q);

/// Mean of a polynomial of y in one stream, in wall coordinates.
/// @pre the degree is at most 6
double polynomial_mean(const Simulation& simulation, const StreamRecord& record,
                       const numerics::Polynomial& g);

/// Mean of y^p y'^q in one stream, in physical coordinates.
double physical_moment(const Simulation& simulation, const StreamRecord& record, int p, int q);

/// Mean of y^p y'^q in every stream, (p, q) among kPowers, in physical coordinates.
std::vector<double> stream_moments(const Simulation& simulation, int p, int q);

/// Excess power of every stream: power of the drawn impulses of the stream less its expectation.
std::vector<double> excess_powers(const Simulation& simulation);

/// Number of effective samples Var(x) / SE^2 of x = y^p y'^q: the number of independent draws whose
/// mean has the same standard error.
double effective_sample_count(const Simulation& simulation, int p, int q);

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
