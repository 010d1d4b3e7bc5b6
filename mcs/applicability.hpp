#pragma once

#include <string>

#include "mcs/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {

/// Why this solver does not support a problem, in one phrase; empty where it does.
std::string unsupported_reason(const problem::Problem& problem, const Options& options);

/// Why splitting does not resolve the tails of an oscillator outside the paper's class: its energy
/// rises between impulses too. Empty where the energy rises at impulses only.
std::string unsupported_splitting_reason(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::mcs
