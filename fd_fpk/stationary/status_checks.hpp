#pragma once

#include "fd_fpk/operator/grid.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/summary.hpp"

namespace fpkcheck::fd_fpk {

/// Changes `ok` to `failed`, with a reason, if the density on the walls of its box is not
/// negligible.
void check_box(const problem::Frame& frame, const Grid& grid, Result& result);

/// Changes `ok` to `inadmissible` if the density is negative beyond the limit of kStationaryLimits,
/// or if the residual of the power balance is outside kStationaryLimits or outside the requested
/// accuracy.
void check_resolution(const Options& options, Result& result);

/// Changes `ok` to `inaccurate` if the balance of power, of the virial or of momentum has a
/// residual above kMaxBalanceResidual. For oscillators other than the paper's, for which an
/// independent solution may be unavailable.
void check_balances(Result& result);
inline constexpr double kMaxBalanceResidual = 1e-4;

/// Changes `ok` to `inaccurate` if the estimated L1 error exceeds the requested accuracy, or if
/// there is no estimate.
void check_error(const Options& options, Result& result);

}  // namespace fpkcheck::fd_fpk
