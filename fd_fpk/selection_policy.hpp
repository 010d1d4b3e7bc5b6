#pragma once

#include <cmath>
#include <optional>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

/// The selection policy of the solver: all choices of algorithm, order, grid and box that depend on
/// the problem. Each choice has its thresholds, and the reason or experiment for each threshold, in
/// selection_policy.cpp. The options may override each choice.
namespace fpkcheck::fd_fpk {

/// Whether the density has one peak and one length scale for each axis, those of equivalent
/// linearisation. For such problems the solver chooses box, grid and transport by the scales of
/// equivalent linearisation, for all other problems by the density on a coarse grid. Reason: to
/// compute the density on a coarse grid would take most of the time (`fpkcheck fd`: 0.32 s for 0.22
/// s in case 1, 3.1 s for 0.34 s in case 4).
bool has_linearised_scales(const problem::Problem& problem);

// Transport.

/// Number of impulses per decay time above which the density is not computed along characteristics,
/// because characteristics would visit too many cells.
inline constexpr double kMostImpulsesOfCharacteristics = 3000;
/// Whether the solver first tries transport along characteristics, at the given number of impulses
/// per decay time.
bool are_characteristics_preferred(const problem::Problem& problem, double per_decay_time);
/// Whether upwind differences cannot resolve the density, because the density is unbounded or
/// because flights between impacts are shorter than a cell.
bool are_characteristics_required(const problem::Problem& problem);

// Order.

/// Automatic order if no wall dissipates energy and the density may have several length scales.
/// Without losses at a wall the density has no jump along the orbit that grazes the wall, and order
/// 7 with wider cells is more accurate than order 5 at equal cost (docs/performance.md).
inline constexpr int kHighOrder = 7;
/// Factor of the cell widths of schemes of order kHighOrder.
inline constexpr double kHighOrderWidthFactor = 1.2;
/// Automatic order of the transport terms for the stationary density.
int automatic_order(const problem::Problem& problem);

// Box.

/// Factor of Options::wall_density for the stationary density on upwind grids, without
/// has_linearised_scales().
double wall_density_factor(const problem::Problem& problem);

// Grid.

/// Limits that a density must satisfy to count as resolved by its grid.
struct ResolutionLimits {
  double min_density;  ///< smallest accepted density relative to the peak, <= 0
  double power;        ///< largest accepted |residual| of the power balance, relative to the input

  /// The functions is_density_accepted and is_power_residual_accepted return false for NaN.
  bool is_density_accepted(double relative_min_density) const {
    return relative_min_density >= min_density;
  }
  bool is_power_residual_accepted(double residual) const { return std::abs(residual) <= power; }
};

/// An automatic grid whose density violates kAutomaticGridLimits is refined. kAutomaticGridLimits
/// is stricter than kStationaryLimits (stationary/status_checks.hpp), so that the density on an
/// automatic grid satisfies kStationaryLimits with a margin.
inline constexpr ResolutionLimits kAutomaticGridLimits{.min_density = -1e-5, .power = 5e-4};

/// L1 error estimate down to which an automatic grid is refined, if the time limit permits.
inline constexpr double kTargetAccuracy = 1e-4;

/// Whether the status of a solution can be `ok` only if the residuals of its balances are small
/// (kMaxBalanceResidual). For such a problem an automatic grid is refined until the status is `ok`.
/// Reason: no closure and no independent discretisation may be available that would reveal a wrong
/// density.
bool must_satisfy_balances(const problem::Problem& problem);

/// Whether the options permit the solver to choose finer grids.
bool has_automatic_grid(const Options& options);

/// Whether the joint density is unbounded at the rest point (problem::impulses_per_decay_time).
bool is_unbounded_at_origin(const problem::Problem& problem);

/// Whether there is a wall at which the relative jump of the density at x2 = 0, 1/r^2 - 1, exceeds
/// a tenth.
bool has_dissipative_impacts(const std::optional<problem::Wall>& wall);

/// Automatic ratio of the cell width far from the origin to the cell width at the origin, for grids
/// refined at the origin.
inline constexpr double kOriginRefinement = 16;
/// Automatic ratio of the cell widths of x2 far from the origin and at the origin, under white
/// noise with losses at the impact. Under white noise with such losses the density at the wall is
/// proportional to u^-beta, with u the speed, and schemes of orders 3 and 5 limit the length
/// Grading::core of x1 to the cube of that of x2, divided by D2.
inline constexpr double kOriginRefinementUnderWhiteNoise = 32;

/// The value of options.origin_refinement, or the automatic value if the option is not set.
double origin_refinement(const problem::Problem& problem, const Options& options);

/// Lengths over which the density varies in x1 and in x2; 0 for a length that is not yet
/// determined.
struct LengthScales {
  double x1 = 0, x2 = 0;
};

/// Gradings of the cells of x1 towards walls, and of the cells of x2 towards 0.
struct Gradings {
  Grading x1, x2;
  bool at_left_wall = false, at_right_wall = false;
};
Gradings gradings(const problem::Problem& problem, const Options& options,
                  const LengthScales& lengths);

/// Cell widths in x1 and x2 far from the refinement points.
LengthScales cell_widths(const problem::Problem& problem, const Options& options,
                         const LengthScales& lengths);

}  // namespace fpkcheck::fd_fpk
