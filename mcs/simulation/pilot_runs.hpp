#pragma once

#include "mcs/simulation/simulation_plan.hpp"
#include "mcs/streams/importance_splitting.hpp"

namespace fpkcheck::mcs {

/// Chooses the energy thresholds of the splitting for a problem by pilot runs with independent
/// random numbers. Each pilot run uses the thresholds of the run before and adds higher thresholds.
/// The probability that the energy after an impulse exceeds the last threshold is about 1e-10.
ImportanceSplitting choose_splitting_thresholds(const problem::Problem& problem,
                                                const SimulationPlan& plan);

}  // namespace fpkcheck::mcs
