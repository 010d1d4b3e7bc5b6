#pragma once

#include <span>
#include <string>

#include "problem/problem.hpp"

namespace fpkcheck::report {

/// Returns the problem in words and the equation of motion. The equation has every term that occurs
/// in at least one of the problems.
/// @param problems at least one problem
std::string problem_statement(std::span<const problem::Problem* const> problems);

}  // namespace fpkcheck::report
