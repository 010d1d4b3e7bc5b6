#pragma once

#include <cmath>
#include <string>

#include "fd_fpk/operator/grid.hpp"
#include "problem/frame.hpp"

namespace fpkcheck::fd_fpk {

/// What a density that its grid resolves does not exceed.
struct ResolutionBars {
  double least_density;  ///< relative to the peak: an exact density is nowhere negative
  double power;          ///< by which the balance of power may be missed, relative to the input

  /// Both are false of what is not a number.
  bool allow_density(double least) const { return least >= least_density; }
  bool allow_imbalance(double residual) const { return std::abs(residual) <= power; }
};

/// An automatic grid that exceeds these is refined. Stricter than what follows: a grid that was
/// found automatically should not end up next to the bar.
inline constexpr ResolutionBars kAutomaticGridBars{.least_density = -1e-5, .power = 5e-4};

/// A stationary density that exceeds these is `inadmissible`.
inline constexpr ResolutionBars kStationaryBars{.least_density = -1e-4, .power = 1e-3};

/// Likewise of a density over time. With losses at the impact its start does not obey the impact
/// condition: a step travels from the wall into the plane until the noise has smoothed it, and no
/// grid resolves a step. The bars allow for that, and still catch grids that are too coarse.
inline constexpr ResolutionBars kBarsOverTime{.least_density = -1e-3, .power = 1e-2};

/// Density on a wall, relative to the peak, above which no box is accepted, of either kind: what
/// has left the box is missing whether the rest is stationary or not.
inline constexpr double kMostOnWall = 1e-3;

/// Why the box does not hold a density with so much on its walls; empty when it does.
/// @param frame in which the grid stands: the box is named in physical coordinates
/// @param when "at t = 1 ", or nothing
std::string box_objection(const problem::Frame& frame, const Grid& grid, const WallDensity& wall,
                          const std::string& when = "");

}  // namespace fpkcheck::fd_fpk
