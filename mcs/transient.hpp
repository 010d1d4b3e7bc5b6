#pragma once

#include "mcs/options.hpp"
#include "problem/problem.hpp"
#include "transform/transient.hpp"

namespace fpkcheck::mcs {

/// Estimates the density over time from independent paths whose initial states are drawn from the
/// initial density. The errors of the moments are standard errors; the errors of the marginals are
/// expected L1 sampling errors, and the marginals have 95 % confidence intervals. Under noise the
/// errors contain an estimate of the error by the interval between noise kicks, from a second
/// simulation with twice the interval.
/// @param options SimulationOptions::time is the simulated time of all paths
/// @throws InputError as make_simulation_plan(), or if the initial mean is behind a wall
transform::TransientDensities estimate_transient(const problem::Problem& problem,
                                                 const SimulationOptions& options,
                                                 const transform::TransientRequest& request);

}  // namespace fpkcheck::mcs
