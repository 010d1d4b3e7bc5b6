#pragma once

#include "fd_fpk/operator/grid.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/summary.hpp"

namespace fpkcheck::fd_fpk {

/// Takes the `ok` from a solution whose density fills its box to the walls, and says why.
void judge_box(const problem::Frame& frame, const Grid& grid, Result& result);

/// The same of one whose density is negative or misses the balance of power by more than
/// kStationaryBars (of power: or the accuracy asked for) allow.
void judge_resolution(const Options& options, Result& result);

/// The same of one that misses a balance of power, virial or momentum by more than kBalances:
/// `inaccurate`. Beyond the paper's class, where no other solver may be at hand.
void judge_balances(Result& result);
inline constexpr double kBalances = 1e-4;

/// The same of one whose estimated error in L1 is larger than the accuracy asked for, or that has no
/// estimate: `inaccurate`.
void judge_error(const Options& options, Result& result);

}  // namespace fpkcheck::fd_fpk
