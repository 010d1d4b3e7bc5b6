#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "fd_fpk/options.hpp"
#include "fd_fpk/solve.hpp"

namespace fpkcheck::fd_fpk {

/// Cells of a level are this much narrower than those of the one before.
inline constexpr double kLevelRatio = 1.4142135623730951;

/// The discretisation error of the last of three solutions u_0, u_1, u_2 on grids refined by
/// kLevelRatio. If the differences fall by R = |u_1 - u_0| / |u_2 - u_1|, the error of u_2 is
///
///     |u_2 - u_1| / (R - 1),    and u_2 + (u_2 - u_1) / (R - 1) the Richardson limit.
///
/// R comes from the L1 differences of the marginals, and is kept between that of order 1 and that
/// of the scheme, so that chance agreement is not taken for accuracy. It is an estimate and no
/// bound: the order changes from grid to grid, and it has been low by up to a factor of 2.5.
/// @param order of the scheme
/// @pre all three have a density
ErrorEstimate estimate_error(const transform::Solution& coarse, const transform::Solution& middle,
                             const transform::Solution& fine, int order);

/// Order observed below which three grids do not tell what they tend to: there is an estimate of
/// the error then, but no limit.
inline constexpr double kLeastOrderOfALimit = 1.5;

/// An error estimate in L1 beyond which a density is `inadmissible`: its grid does not resolve it.
inline constexpr double kUnresolvedError = 0.05;

/// Solves one problem with given options on one grid.
using SolveOnOneGrid = std::function<Result(const Options&)>;

/// The solution on the grid of the options, with its error estimated from grids of cells wider by
/// kLevelRatio and its square (direct solves). The solution carries its extrapolation
/// where the observed order is at least kLeastOrderOfALimit.
Result solve_with_error_estimate(const SolveOnOneGrid& solve, const Options& options);

/// The solution on the first of a sequence of grids, each with cells narrower by kLevelRatio, whose
/// error estimate meets options.tolerance: L1 of both marginals, and the second moments relative.
/// When the differences fall more slowly than with the order of the scheme, cells are graded
/// towards the origin. Status `not_converged` when the largest grid does not meet it. The solution
/// carries its extrapolation as above.
Result solve_to_tolerance(const SolveOnOneGrid& solve, const Options& options);

}  // namespace fpkcheck::fd_fpk
