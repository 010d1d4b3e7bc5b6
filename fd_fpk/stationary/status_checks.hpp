#pragma once

#include <string>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/summary.hpp"
#include "problem/walls.hpp"

namespace fpkcheck::fd_fpk {

/// A stationary density that violates these limits is `inadmissible`.
inline constexpr ResolutionLimits kStationaryLimits{.min_density = -1e-4, .power = 1e-3};

/// A density over time that violates these limits is `inadmissible`. With losses at the impact the
/// initial density does not satisfy the impact condition: a discontinuity of the density travels
/// from the wall into the plane until the noise smooths the discontinuity. No grid resolves a
/// discontinuity. These limits allow for the discontinuity and still detect grids that are too
/// coarse.
inline constexpr ResolutionLimits kTransientLimits{.min_density = -1e-3, .power = 1e-2};

/// Largest accepted density on a wall of the box, relative to the peak. A box with a larger density
/// is rejected, because probability that has left the box is missing. The limit applies to
/// stationary and transient densities.
inline constexpr double kMaxWallDensity = 1e-3;

/// The reason why a box with these wall densities is too small; empty if the box is large enough.
/// @param frame map from the wall coordinates of the grid to physical coordinates, in which the
/// message states the box
/// @param when words that the message puts in front, such as "at t = 1 "; may be empty
std::string box_failure_reason(const problem::Frame& frame, const Grid& grid,
                               const WallDensity& wall, const std::string& when = "");

/// Changes `ok` to `failed`, with a reason, if the density on the walls of its box is not
/// negligible.
void check_box(const problem::Frame& frame, const Grid& grid, Result& result);

/// Changes `ok` to `inadmissible` if the density is negative beyond the limit of kStationaryLimits,
/// or if the residual of the power balance is outside kStationaryLimits or outside the requested
/// accuracy.
void check_resolution(const Options& options, Result& result);

/// Changes `ok` to `inaccurate` if the balance of power, of the virial or of momentum has a
/// residual above kMaxBalanceResidual. For problems that must_satisfy_balances().
void check_balances(Result& result);
inline constexpr double kMaxBalanceResidual = 1e-4;

/// Changes `ok` to `inaccurate` if the estimated L1 error exceeds the requested accuracy, or if
/// there is no estimate.
void check_error(const Options& options, Result& result);

}  // namespace fpkcheck::fd_fpk
