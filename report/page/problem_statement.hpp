#pragma once

#include <span>
#include <string>

#include "problem/problem.hpp"

namespace fpkcheck::report {

/// What is solved, in words and as a formula, with the terms that some of the problems have.
/// @param problems at least one
std::string problem_statement(std::span<const problem::Problem* const> problems);

}  // namespace fpkcheck::report
