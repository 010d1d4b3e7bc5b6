#pragma once

#include <optional>

#include "mcs/simulation/simulation.hpp"
#include "mcs/simulation/simulation_plan.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::mcs {

/// Returns the longest interval between noise kicks, or between the evenly spaced impulses that
/// replace white noise; empty without noise.
std::optional<double> longest_kick_interval(const SimulationPlan& plan);

/// Multiplies the intervals between noise kicks, or between the evenly spaced impulses that replace
/// white noise.
void scale_kick_intervals(const problem::Problem& problem, double factor, SimulationPlan& plan);

/// Returns the plan of a second simulation with twice the interval between the kicks of white
/// noise, and with other random numbers; empty without noise kicks.
std::optional<SimulationPlan> plan_with_doubled_kick_interval(const problem::Problem& problem,
                                                              const SimulationPlan& plan);

/// Returns whether the interval between noise kicks causes an error of stationary averages. Without
/// impact losses and impulses the kicks and flights preserve the stationary density (class
/// NoiseKicks); the interval then causes an error only of quantities that depend on several times.
bool kick_interval_affects_stationary_density(const SimulationPlan& plan);

/// Returns the order p of the errors that the interval between kicks causes: 1 if impacts dissipate
/// energy or the force jumps, and 2 otherwise (docs/simulation.md).
int order_in_kick_interval(const SimulationPlan& plan);

/// Returns the estimate max(|M(2h) - M(h)|, s) / (2^p - 1) of the error of M(h) by the kick
/// interval h, by Richardson extrapolation. A difference that sampling errors hide counts as large
/// as the smallest difference s that the two simulations resolve.
/// @param difference M(2h) - M(h)
/// @param standard_error standard error s of the difference
/// @param order order p of the error
double kick_interval_error(double difference, double standard_error, int order);

/// Returns the estimate of the L1 error of a marginal density by the kick interval, from the L1
/// distance between the densities at the intervals h and 2h.
/// @param expected_by_chance expected L1 distance by sampling errors alone
/// @param largest_by_chance L1 distance up to which sampling errors may explain the distance
/// @param order order p of the error
double kick_interval_l1_error(double l1_distance, double expected_by_chance,
                              double largest_by_chance, int order);

/// Estimates the errors of the stationary moments and marginals that the interval between kicks
/// causes, by kick_interval_error() and kick_interval_l1_error().
/// @param solution moments, marginals and sampling errors of the simulation with the interval h
/// @param doubled simulation with the interval 2h
transform::ErrorEstimate estimate_kick_interval_error(const transform::Solution& solution,
                                                      const Simulation& doubled);

}  // namespace fpkcheck::mcs
