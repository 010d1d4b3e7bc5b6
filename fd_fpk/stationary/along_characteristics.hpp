#pragma once

#include "fd_fpk/options.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "fd_fpk/summary.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {

/// The stationary density of `kf` with the exact impact on one grid, by the embedded Markov chain
/// of the states after impulses. A step of the chain consists of the transport along
/// characteristics between impulses (characteristics/transport_operator.hpp) and of the velocity
/// jump. For rare impulses the transport dominates, and the transport along characteristics is
/// exact. The density may be unbounded at the origin. Status and options are treated as by
/// solve_on_one_grid.
Result solve_along_characteristics(const problem::Problem& problem,
                                   const problem::MotionScales& scales, const Options& options,
                                   const Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
