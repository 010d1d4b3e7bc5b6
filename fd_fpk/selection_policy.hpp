#pragma once

#include <cmath>
#include <optional>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/options.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem.hpp"

/// Selection policy of the solver: all choices of algorithm, order, grid and box that depend on the
/// problem. The file selection_policy.cpp states the thresholds of all choices and the origin of
/// each threshold.
namespace fpkcheck::fd_fpk {

/// Returns whether the scales of equivalent linearisation determine box, grid and transport, since
/// the density has one peak and one length scale for each axis. For all other problems the density
/// on a coarse grid determines box, grid and transport. A coarse grid for every problem would cost
/// time (`fpkcheck fd`: 0.32 s instead of 0.22 s in case 1, 3.1 s instead of 0.34 s in case 4).
bool has_linearised_scales(const problem::Problem& problem);

/// Number of impulses per decay time above which characteristics would visit too many cells
inline constexpr double kMaxImpulsesPerDecayTimeForCharacteristics = 3000;
/// Returns whether the solver first tries transport along characteristics.
bool are_characteristics_preferred(const problem::Problem& problem, double impulses_per_decay_time);
/// Returns whether upwind differences cannot resolve the density, which is unbounded, concentrated
/// on a limit cycle, or has flights between impacts shorter than a cell.
bool are_characteristics_required(const problem::Problem& problem);

/// Automatic order of the scheme for a density with several length scales, without losses at a
/// wall. Without losses, order 7 with wider cells is more accurate than order 5 at equal cost
/// (docs/performance.md).
inline constexpr int kHighFiniteVolumeOrder = 7;
/// Factor by which the cells of a scheme of order kHighFiniteVolumeOrder are wider than the cells
/// of a scheme of lower order
inline constexpr double kCellWidthFactorOfHighOrder = 1.2;
int automatic_scheme_order(const problem::Problem& problem);

/// Returns the factor of FiniteVolumeOptions::wall_density for the stationary density on upwind
/// grids, for problems without has_linearised_scales().
double box_edge_density_factor(const problem::Problem& problem);

/// Limits of the error indicators of a density that counts as resolved by the grid.
struct DensityResolutionLimits {
  double min_density;  ///< smallest accepted density relative to the peak, <= 0
  double power;        ///< largest accepted |residual| of the power balance, relative to the input

  /// The functions is_density_accepted and is_power_residual_accepted return false for NaN.
  bool is_density_accepted(double relative_min_density) const {
    return relative_min_density >= min_density;
  }
  bool is_power_residual_accepted(double residual) const { return std::abs(residual) <= power; }
};

/// An automatic grid whose density violates kAutomaticGridResolutionLimits is refined. The limits
/// of the refinement are stricter than the limits of the status `ok`, kStationaryResolutionLimits
/// (stationary/status_checks.hpp), and leave a margin.
inline constexpr DensityResolutionLimits kAutomaticGridResolutionLimits{.min_density = -1e-5,
                                                                        .power = 5e-4};

/// Returns whether the densities of all grids are expected to be as negative as the density of a
/// grid, since the impact to first order in 1-r has no nonnegative density. No finer grid is then
/// solved to make the density nonnegative.
/// @param min_density smallest density on the grid, relative to the peak
bool has_negative_density_on_all_grids(const FiniteVolumeOptions& options, double min_density);

/// L1 error estimate down to which an automatic grid is refined, if the time limit permits.
inline constexpr double kAutomaticGridTargetL1Error = 1e-4;

/// Returns whether the status `ok` requires small residuals of the balances (kMaxBalanceResidual)
/// and a refinement of the grid until the status is `ok`. Small residuals are required for problems
/// for which possibly no other method would reveal a wrong density.
bool must_satisfy_balances(const problem::Problem& problem);

/// Returns whether the options permit the solver to choose finer grids.
bool has_automatic_grid(const FiniteVolumeOptions& options);

/// Returns whether rare impulses make the joint density unbounded at the rest point.
bool is_density_unbounded_at_origin(const problem::Problem& problem);

/// Returns whether the relative discontinuity 1/r^2 - 1 of the density at a wall exceeds a tenth.
bool has_dissipative_impacts(const std::optional<problem::Wall>& wall);

/// Automatic ratio of the cell width far from the origin to the cell width at the origin
inline constexpr double kOriginRefinement = 16;
/// Automatic ratio of the cell widths of x2 under white noise with losses at the impact. The
/// density at the wall is proportional to u^-beta, with the speed u. For schemes of order 3 and 5,
/// the length CellGrading::core of x1 is at most the cube of the length CellGrading::core of x2,
/// divided by the noise coefficient D2.
inline constexpr double kOriginRefinementUnderWhiteNoise = 32;

/// Automatic ratio of the cell widths of x2 where the force jumps at x2 = 0, without losses at a
/// wall. The jump reduces the order to about 4. For 0.2 sign(v) + y under white noise of intensity
/// 0.2 the first grid has a residual of the power balance of 7e-6 instead of 6e-5 with the ratio 2
/// (`fpkcheck fd --origin-refinement 2`); with the ratio 1 the first grid is not `ok`.
inline constexpr double kForceJumpRefinement = 4;

/// Returns options.origin_refinement, or the automatic ratio if the option is not set.
double effective_origin_refinement(const problem::Problem& problem,
                                   const FiniteVolumeOptions& options);

/// Length scales of the density in x1 and in x2; 0 for a length that is not yet determined.
struct DensityLengthScales {
  double x1 = 0, x2 = 0;
};

/// Gradings of the cells of x1 towards walls, and of the cells of x2 towards 0.
struct GridCellGradings {
  CellGrading x1, x2;
  bool at_left_wall = false, at_right_wall = false;
};
GridCellGradings automatic_gradings(const problem::Problem& problem,
                                    const FiniteVolumeOptions& options,
                                    const DensityLengthScales& lengths);

/// Returns the cell widths in x1 and x2 far from the refinement points.
DensityLengthScales automatic_cell_widths(const problem::Problem& problem,
                                          const FiniteVolumeOptions& options,
                                          const DensityLengthScales& lengths);

}  // namespace fpkcheck::fd_fpk
