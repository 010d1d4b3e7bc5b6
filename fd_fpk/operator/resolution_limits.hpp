#pragma once

#include <cmath>
#include <string>

#include "fd_fpk/operator/grid.hpp"
#include "problem/frame.hpp"

namespace fpkcheck::fd_fpk {

/// Limits that a density must satisfy to count as resolved by its grid.
struct ResolutionLimits {
  double min_density;  ///< smallest accepted density relative to the peak, <= 0
  double power;        ///< largest accepted |residual| of the power balance, relative to the input

  /// Both of the following functions return false for NaN.
  bool is_density_accepted(double relative_min_density) const {
    return relative_min_density >= min_density;
  }
  bool is_power_residual_accepted(double residual) const { return std::abs(residual) <= power; }
};

/// An automatic grid that violates these limits is refined. These limits are stricter than
/// kStationaryLimits, so that the density on an automatic grid satisfies kStationaryLimits with a
/// margin.
inline constexpr ResolutionLimits kAutomaticGridLimits{.min_density = -1e-5, .power = 5e-4};

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

}  // namespace fpkcheck::fd_fpk
