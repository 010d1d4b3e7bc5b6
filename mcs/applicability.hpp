#pragma once

#include <string>

#include "mcs/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {

/// The reason why the simulation does not support a problem with these options, in one phrase.
/// Empty if the problem is supported.
std::string unsupported_reason(const problem::Problem& problem, const Options& options);

/// The reason why importance splitting does not resolve the tails of the density if the
/// energy also rises between impulses. Empty if the energy rises at impulses only.
std::string unsupported_splitting_reason(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::mcs
