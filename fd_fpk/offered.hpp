#pragma once

#include <string>

#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Why this solver does not treat a problem, in one phrase; empty where it does.
std::string objection(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::fd_fpk
