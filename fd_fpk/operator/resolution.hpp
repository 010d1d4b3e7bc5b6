#pragma once

#include <cmath>
#include <string>

#include "fd_fpk/operator/grid.hpp"
#include "problem/frame.hpp"

namespace fpkcheck::fd_fpk {

/// Limits for a density that its grid resolves.
struct ResolutionLimits {
  double min_density;  ///< smallest density relative to the peak: an exact density is nonnegative
  double power;        ///< residual of the power balance, relative to the input

  /// Both functions return false for NaN.
  bool is_density_accepted(double least) const { return least >= min_density; }
  bool is_imbalance_accepted(double residual) const { return std::abs(residual) <= power; }
};

/// An automatic grid that violates these limits is refined. They are stricter than the limits
/// below: an automatic grid should not be close to those.
inline constexpr ResolutionLimits kAutomaticGridLimits{.min_density = -1e-5, .power = 5e-4};

/// A stationary density that violates these limits is `inadmissible`.
inline constexpr ResolutionLimits kStationaryLimits{.min_density = -1e-4, .power = 1e-3};

/// Likewise for a density over time. With losses at the impact the initial density does not satisfy
/// the impact condition: a discontinuity travels from the wall into the plane until the noise
/// smooths it, and no grid resolves it. These limits allow for the discontinuity and still detect
/// grids that are too coarse.
inline constexpr ResolutionLimits kTransientLimits{.min_density = -1e-3, .power = 1e-2};

/// Density on a wall relative to the peak, above which a box is rejected, for stationary and
/// transient densities: probability that has left the box is missing in both.
inline constexpr double kMaxWallDensity = 1e-3;

/// Reason why a box with these wall densities is too small; empty when the box is large enough.
/// @param frame wall coordinates of the grid: the message states the box in physical coordinates
/// @param when "at t = 1 ", or nothing
std::string box_failure_reason(const problem::Frame& frame, const Grid& grid,
                               const WallDensity& wall, const std::string& when = "");

}  // namespace fpkcheck::fd_fpk
