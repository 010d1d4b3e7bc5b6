#pragma once

#include <string>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/summary.hpp"
#include "problem/walls.hpp"

namespace fpkcheck::fd_fpk {

/// Limits of a stationary density; a violation gives the status `inadmissible`.
inline constexpr ResolutionLimits kStationaryLimits{.min_density = -1e-4, .power = 1e-3};

/// Limits of a density over time; a violation gives the status `inadmissible`. With losses the
/// initial density does not satisfy the impact condition, and a discontinuity travels from the wall
/// into the plane. No grid resolves the discontinuity, which the noise smooths. The limits allow
/// for the discontinuity and still detect grids that are too coarse.
inline constexpr ResolutionLimits kTransientLimits{.min_density = -1e-3, .power = 1e-2};

/// Largest accepted density on an edge of the box, relative to the peak. A box with a larger
/// density on an edge is rejected, because probability that has left the box is missing.
inline constexpr double kMaxBoxEdgeDensity = 1e-3;

/// Returns the reason why a box with the given densities on the edges is too small; empty for a box
/// that is large enough.
/// @param frame map from the wall coordinates of the grid to the physical coordinates of the
/// message
/// @param when words in the message before the density, such as "at t = 1 "; may be empty
std::string box_failure_reason(const problem::WallFrame& frame, const Grid& grid,
                               const BoxEdgeDensity& wall, const std::string& when = "");

/// Changes the status `ok` to `failed`, with a reason, if the density on the edges of the box is
/// not negligible.
void check_box_size(const problem::WallFrame& frame, const Grid& grid, Result& result);

/// Changes the status `ok` to `inadmissible` if the density is too negative or the residual of the
/// power balance is too large. The limit of the residual is the larger of kStationaryLimits.power
/// and options.accuracy.
void check_resolution(const Options& options, Result& result);

/// Changes the status `ok` to `inaccurate` if the balance of power, virial or momentum has a
/// residual above kMaxBalanceResidual times Summary::exchanged_power. The check is for problems
/// that must_satisfy_balances().
void check_balances(Result& result);
inline constexpr double kMaxBalanceResidual = 1e-4;

/// Changes the status `ok` to `inaccurate` if the estimated L1 error exceeds the requested accuracy
/// or is unknown.
void check_error_estimate(const Options& options, Result& result);

}  // namespace fpkcheck::fd_fpk
