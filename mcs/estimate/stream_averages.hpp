#pragma once

#include <vector>

#include "mcs/estimate/stream_weights.hpp"
#include "mcs/simulation/simulation.hpp"
#include "numerics/polynomials/polynomial.hpp"
#include "transform/joint_density.hpp"

namespace fpkcheck::mcs {

/// Returns the mean of y^p y'^q in one trajectory stream, in wall coordinates, for (p, q) =
/// (y_power, v_power) among kRecordedMomentPowers.
double moment_in_wall_coordinates(const Simulation& simulation,
                                  const TrajectoryStreamStatistics& record, int y_power,
                                  int v_power);

/// Returns the mean of a polynomial g(y) in one trajectory stream, in wall coordinates.
/// @pre the degree of the polynomial is at most 6
double mean_of_polynomial_in_y(const Simulation& simulation,
                               const TrajectoryStreamStatistics& record,
                               const numerics::Polynomial& g);

/// Returns the mean of y^p y'^q in one trajectory stream, in physical coordinates, for (p, q) =
/// (y_power, v_power) among kRecordedMomentPowers.
double moment_in_physical_coordinates(const Simulation& simulation,
                                      const TrajectoryStreamStatistics& record, int y_power,
                                      int v_power);

/// Returns the mean of y^p y'^q in every trajectory stream, in physical coordinates, for (p, q) =
/// (y_power, v_power) among kRecordedMomentPowers.
std::vector<double> moment_per_stream(const Simulation& simulation, int y_power, int v_power);

struct MomentEstimates {
  transform::Moments means, standard_errors;
};
/// Returns the moments in physical coordinates, as weighted means over the trajectory streams.
MomentEstimates estimate_moments(const Simulation& simulation,
                                 const TrajectoryStreamWeights& weights);

/// Returns the excess power of every trajectory stream: power of the drawn impulses minus the
/// expected power of the impulses.
std::vector<double> excess_impulse_power_per_stream(const Simulation& simulation);

/// Returns the effective number of samples Var(x) / SE^2 of x = y^p y'^q, p = y_power, q = v_power:
/// the number of independent draws whose mean has the same standard error.
double effective_sample_count(const Simulation& simulation, int y_power, int v_power);

/// Returns the rates of upward crossings of levels of y: the number of maxima of y above the level
/// minus the number of minima of y above the level, per unit time. Between an upward and a downward
/// crossing of a level, y has one more maximum than minima. The crossing levels are every tenth bin
/// edge of y, beginning with the first edge above the wall.
std::vector<RateOfEventsAtLevel> estimate_upcrossing_rates(const Simulation& simulation,
                                                           const TrajectoryStreamWeights& weights);

/// Returns the rates of maxima of y above 0 and above the levels of estimate_upcrossing_rates().
/// The rate of maxima above a level, divided by the rate of maxima above 0, is the probability that
/// a peak exceeds the level.
std::vector<RateOfEventsAtLevel> estimate_peak_rates(const Simulation& simulation,
                                                     const TrajectoryStreamWeights& weights);

}  // namespace fpkcheck::mcs
