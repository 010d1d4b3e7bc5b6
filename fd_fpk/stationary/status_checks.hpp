#pragma once

#include <string>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/summary.hpp"
#include "problem/walls.hpp"

namespace fpkcheck::fd_fpk {

/// Limits of the error indicators of a stationary density; a violation gives the status
/// `inadmissible`.
inline constexpr DensityResolutionLimits kStationaryResolutionLimits{.min_density = -1e-4,
                                                                     .power = 1e-3};

/// Limits of the error indicators of a density over time; a violation gives the status
/// `inadmissible`. With losses the initial density does not satisfy the impact condition, and a
/// discontinuity travels from the wall into the plane. No grid resolves this discontinuity of the
/// density, which the noise smooths. The limits allow for the discontinuity and still detect grids
/// that are too coarse.
inline constexpr DensityResolutionLimits kTransientResolutionLimits{.min_density = -1e-3,
                                                                    .power = 1e-2};

/// Largest accepted density on an edge of the computational box, relative to the peak density. A
/// computational box with a larger density on an edge is rejected, because probability that has
/// left the computational box is missing.
inline constexpr double kMaxBoxEdgeDensity = 1e-3;

/// Returns the reason why a computational box with the given densities on the edges is too small;
/// empty for a computational box that is large enough.
/// @param frame map from the wall coordinates of the grid to the physical coordinates of the
/// message
/// @param when words in the message before the density, such as "at t = 1 "; may be empty
std::string small_box_failure_reason(const problem::WallFrame& frame, const PhasePlaneGrid& grid,
                                     const BoxEdgeDensity& wall, const std::string& when = "");

/// Changes the status `ok` to `failed`, with a reason, if the density on the edges of the
/// computational box is not negligible.
void check_box_size(const problem::WallFrame& frame, const PhasePlaneGrid& grid,
                    FiniteVolumeResult& result);

/// Changes the status `ok` to `inadmissible` if the density is too negative or the residual of the
/// power balance is too large. The largest accepted residual of the power balance is the larger of
/// kStationaryResolutionLimits.power and options.accuracy.
void check_resolution(const FiniteVolumeOptions& options, FiniteVolumeResult& result);

/// Changes the status `ok` to `inaccurate` if the balance of power, virial or momentum has a
/// residual above kMaxBalanceResidual times FiniteVolumeSummary::exchanged_power. This check of
/// balances is for problems with must_satisfy_balances().
void check_balances(FiniteVolumeResult& result);
inline constexpr double kMaxBalanceResidual = 1e-4;

/// Changes the status `ok` to `inaccurate` if the estimated L1 error exceeds the requested accuracy
/// or is unknown.
void check_error_estimate(const FiniteVolumeOptions& options, FiniteVolumeResult& result);

}  // namespace fpkcheck::fd_fpk
