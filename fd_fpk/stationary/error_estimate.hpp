#pragma once

#include <functional>

#include "fd_fpk/options.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "fd_fpk/summary.hpp"

namespace fpkcheck::fd_fpk {

/// The discretisation error of the last of three solutions on grids refined by
/// transform::kLevelRatio, by transform::richardson; neighbours are compared on the cells of the
/// finer one. An estimate and no bound: it has been low by up to a factor of 2.5.
/// @param order of the scheme
/// @pre all three have a density
ErrorEstimate estimate_error(const Result& coarse, const Result& middle, const Result& fine,
                             int order);

/// Solves one problem with given options on one grid.
using SolveOnOneGrid = std::function<Result(const Options&)>;

/// The solution on the grid of the options, with its error estimated from grids of cells wider by
/// transform::kLevelRatio and its square (direct solves). The solution carries its extrapolation
/// where transform::has_limit says so of the observed order.
Result solve_with_error_estimate(const SolveOnOneGrid& solve, const Options& options);

/// The error in L1 that the automatic grid is made for where it can be had in time.
inline constexpr double kUsualAccuracy = 1e-4;

/// What solve_within() goes on for.
struct Aim {
  double accuracy = kUsualAccuracy;
  bool until_ok = false;  ///< finer grids also where the error is small and the status not `ok`
};

/// As above, and on finer grids as long as the estimate is larger than the accuracy of the aim and
/// either that many cells usually take but a part of the time, or the solution is not `ok` yet. One
/// that is not there at the deadline is given up.
Result solve_within(const SolveOnOneGrid& solve, const Options& options, const Deadline& deadline,
                    const Aim& aim);

/// Whether the one is ok and the other is not, or has an error estimate, or the smaller one.
bool better(const Result& one, const Result& other);

/// The solution on the first of a sequence of grids, each with cells narrower by
/// transform::kLevelRatio, whose error estimate meets options.tolerance: L1 of both marginals, and
/// the second moments relative. When the differences fall more slowly than with the order of the
/// scheme, cells are graded towards the origin. Status `not_converged` when the largest grid that
/// the deadline or the number of cells allows does not meet it. The solution carries its
/// extrapolation as above.
Result solve_to_tolerance(const SolveOnOneGrid& solve, const Options& options,
                          const Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
