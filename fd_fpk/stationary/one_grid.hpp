#pragma once

#include "fd_fpk/options.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "fd_fpk/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// The stationary density on the grid and in the box that the options come to, and whether it can
/// be believed; Options::error_estimate and tolerance are for who calls this on several grids. Its
/// identity is left to them too. The statuses are those of solve().
Result solve_on_one_grid(const problem::Problem& problem, const Surroundings& surroundings,
                         const Options& options, const Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
