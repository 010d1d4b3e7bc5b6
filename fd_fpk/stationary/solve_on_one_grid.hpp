#pragma once

#include "fd_fpk/options.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "fd_fpk/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// The stationary density on the grid and in the box of the options, with its status as in solve().
/// Options::error_estimate and tolerance are ignored: the callers that solve on several grids use
/// these two options. The caller sets the identity of the solution.
Result solve_on_one_grid(const problem::Problem& problem, const ScalesAndBox& scales_and_box,
                         const Options& options, const Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
