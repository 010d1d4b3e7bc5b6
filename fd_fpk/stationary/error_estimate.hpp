#pragma once

#include <functional>

#include "fd_fpk/options.hpp"
#include "fd_fpk/summary.hpp"

namespace fpkcheck::fd_fpk {

/// The discretisation error of the last of three solutions on grids refined by
/// transform::kLevelRatio, by transform::richardson; neighbours are compared on the cells of the
/// finer one. An estimate and no bound: it has been low by up to a factor of 2.5.
/// @param order of the scheme
/// @pre all three have a density
ErrorEstimate estimate_error(const transform::Solution& coarse, const transform::Solution& middle,
                             const transform::Solution& fine, int order);

/// An error estimate in L1 beyond which a density is `inadmissible`: its grid does not resolve it.
inline constexpr double kUnresolvedError = 0.05;

/// Solves one problem with given options on one grid.
using SolveOnOneGrid = std::function<Result(const Options&)>;

/// The solution on the grid of the options, with its error estimated from grids of cells wider by
/// transform::kLevelRatio and its square (direct solves). The solution carries its extrapolation
/// where the observed order is at least transform::kLeastOrderOfALimit.
Result solve_with_error_estimate(const SolveOnOneGrid& solve, const Options& options);

/// The solution on the first of a sequence of grids, each with cells narrower by
/// transform::kLevelRatio, whose error estimate meets options.tolerance: L1 of both marginals, and
/// the second moments relative. When the differences fall more slowly than with the order of the
/// scheme, cells are graded towards the origin. Status `not_converged` when the largest grid does
/// not meet it. The solution carries its extrapolation as above.
Result solve_to_tolerance(const SolveOnOneGrid& solve, const Options& options);

}  // namespace fpkcheck::fd_fpk
