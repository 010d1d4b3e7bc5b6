#pragma once

#include "mcs/simulation/plan.hpp"
#include "mcs/streams/splitting.hpp"

namespace fpkcheck::mcs {

/// A splitting for the problem: its thresholds come from short simulations with random numbers of
/// their own, each with the thresholds that the one before could see, until the highest is passed
/// by less than 1e-10 of the states after impulses.
Splitting plan_splitting(const problem::Problem& problem, const Plan& plan);

}  // namespace fpkcheck::mcs
