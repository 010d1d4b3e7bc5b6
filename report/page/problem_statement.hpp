#pragma once

#include <span>
#include <string>

#include "problem/problem.hpp"

namespace fpkcheck::report {

/// The statement of the problem in words and as an equation of motion. The equation has every term
/// that occurs in at least one of the given problems.
/// @param problems the problems; at least one problem
std::string problem_statement(std::span<const problem::Problem* const> problems);

}  // namespace fpkcheck::report
