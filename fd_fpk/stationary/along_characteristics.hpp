#pragma once

#include "fd_fpk/options.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "fd_fpk/summary.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {

/// The stationary density of `kf` with the exact impact on one grid, by the chain of the states
/// right after impulses: along characteristics from one impulse to the next
/// (characteristics/passage.hpp), then by the jump. Where impulses are rare, what is between them
/// is all there is, and it is exact; the density may be unbounded at the origin. As solve_on_one_grid
/// otherwise.
Result solve_along_characteristics(const problem::Problem& problem, const problem::Scales& scales,
                                   const Options& options, const Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
