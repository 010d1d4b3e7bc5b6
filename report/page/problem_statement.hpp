#pragma once

#include <span>
#include <string>

#include "problem/problem.hpp"

namespace fpkcheck::report {

/// The problem in words and as a formula, with all terms that occur in some of the problems.
/// @param problems at least one
std::string problem_statement(std::span<const problem::Problem* const> problems);

}  // namespace fpkcheck::report
