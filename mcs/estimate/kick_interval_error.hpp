#pragma once

#include <optional>

#include "mcs/simulation/simulation.hpp"
#include "mcs/simulation/simulation_plan.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::mcs {

/// Returns the plan of a second simulation with twice the interval between the kicks of white
/// noise, and with other random numbers. Without noise kicks, and where the kick interval causes no
/// error (class NoiseKicks), the result is empty.
std::optional<SimulationPlan> plan_with_doubled_kick_interval(const problem::Problem& problem,
                                                              const SimulationPlan& plan);

/// Estimates the errors that the finite interval h between kicks causes, by Richardson
/// extrapolation from the averages M(h) and M(2h) of two simulations:
///
///     |M(2h) - M(h)| / (2^p - 1),
///
/// with the order p = 1 if impacts dissipate energy or the force jumps, and p = 2 otherwise
/// (docs/simulation.md). A difference that sampling errors hide counts as large as the smallest
/// difference that the two simulations resolve.
/// @param solution moments, marginals and sampling errors of the simulation with the interval h
/// @param doubled simulation with the interval 2h
transform::ErrorEstimate estimate_kick_interval_error(const transform::Solution& solution,
                                                      const Simulation& doubled);

}  // namespace fpkcheck::mcs
