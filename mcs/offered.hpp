#pragma once

#include <string>

#include "mcs/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {

/// Why this solver does not treat a problem, in one phrase; empty where it does.
std::string objection(const problem::Problem& problem, const Options& options);

/// Why there are no tails of an oscillator that is not the paper's: its energy rises elsewhere than
/// at impulses. Empty where it does not.
std::string splitting_objection(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::mcs
