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

/// Limits of the error indicators of a density over time p(y, y', t); a violation gives the status
/// `inadmissible`. With losses at the wall the initial density does not satisfy the impact
/// condition, and a discontinuity travels from the wall into the plane. No grid resolves the
/// travelling discontinuity of the density, which the noise smooths. The limits of the error
/// indicators allow for the discontinuity and still detect grids that are too coarse.
inline constexpr DensityResolutionLimits kTransientResolutionLimits{.min_density = -1e-3,
                                                                    .power = 1e-2};

/// Largest accepted density on an edge of the computational box, relative to the peak density. A
/// computational box is rejected if the density on an edge exceeds kMaxBoxEdgeDensity, because
/// probability that has left the computational box is missing.
inline constexpr double kMaxBoxEdgeDensity = 1e-3;

/// Returns the reason why a computational box with the given densities on the edges is too small;
/// empty for a computational box that is large enough.
/// @param frame transformation from wall coordinates to the physical coordinates of the message
/// @param when time in the message before the density, such as "at t = 1 "; may be empty
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
/// residual above kMaxBalanceResidual times FiniteVolumeSummary::exchanged_power. Balances are
/// checked for problems with must_satisfy_balances(), for which possibly no other method would
/// reveal a wrong density.
void check_balances(FiniteVolumeResult& result);
inline constexpr double kMaxBalanceResidual = 1e-4;

/// Changes the status `ok` to `inaccurate` if the estimated L1 error exceeds the requested accuracy
/// or is unknown.
void check_error_estimate(const FiniteVolumeOptions& options, FiniteVolumeResult& result);

}  // namespace fpkcheck::fd_fpk
