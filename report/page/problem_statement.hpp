#pragma once

#include <span>
#include <string>

#include "problem/problem.hpp"

namespace fpkcheck::report {

/// Returns the problem in words, and an equation of motion with every term of at least one of the
/// problems.
/// @param problems at least one problem
std::string problem_statement(std::span<const problem::Problem* const> problems);

}  // namespace fpkcheck::report
