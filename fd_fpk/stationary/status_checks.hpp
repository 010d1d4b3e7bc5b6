#pragma once

#include "fd_fpk/operator/grid.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/summary.hpp"

namespace fpkcheck::fd_fpk {

/// Changes `ok` to `failed`, with a reason, for a density that is not negligible on the walls of
/// its box.
void check_box(const problem::Frame& frame, const Grid& grid, Result& result);

/// Changes `ok` to `inadmissible` for a density that is negative or has a residual of the power
/// balance outside kStationaryLimits (for the power: or outside the requested accuracy).
void check_resolution(const Options& options, Result& result);

/// Changes `ok` to `inaccurate` where a balance of power, virial or momentum has a residual above
/// kMaxBalanceResidual. For problems outside the paper's class, where an independent solution may
/// be unavailable.
void check_balances(Result& result);
inline constexpr double kMaxBalanceResidual = 1e-4;

/// Changes `ok` to `inaccurate` where the estimated error in L1 exceeds the requested accuracy, or
/// where there is no estimate.
void check_error(const Options& options, Result& result);

}  // namespace fpkcheck::fd_fpk
