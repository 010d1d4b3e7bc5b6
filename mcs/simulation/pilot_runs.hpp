#pragma once

#include "mcs/simulation/plan.hpp"
#include "mcs/streams/splitting.hpp"

namespace fpkcheck::mcs {

/// Splitting for a problem, with thresholds from pilot runs with independent random numbers. Each
/// run uses the thresholds of the run before and extends them. The last threshold has an exceedance
/// probability of about 1e-10 after impulses.
Splitting plan_splitting(const problem::Problem& problem, const Plan& plan);

}  // namespace fpkcheck::mcs
