#pragma once

#include <string>

#include "epc/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc {

/// Why this solver does not treat a problem, in one phrase; empty where it does.
std::string objection(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc
