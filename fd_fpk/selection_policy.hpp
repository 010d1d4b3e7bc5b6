#pragma once

#include <cmath>
#include <optional>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/options.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem.hpp"

/// Automatic choices of algorithm, order, grid and computational box that depend on the problem.
/// The file selection_policy.cpp states the thresholds of the choices and their origin.
namespace fpkcheck::fd_fpk {

/// Returns whether the solver derives computational box, grid and transport scheme from equivalent
/// linearisation, since the density has one peak and one length scale for each axis. For all other
/// problems the solver derives computational box, grid and transport scheme from the density on a
/// coarse grid. A solution on a coarse grid for every problem would cost time (`fpkcheck fd`: 0.32
/// s instead of 0.22 s in case 1, 3.1 s instead of 0.34 s in case 4).
bool has_linearised_scales(const problem::Problem& problem);

/// Number of impulses per decay time above which characteristics would visit too many cells
inline constexpr double kMaxImpulsesPerDecayTimeForCharacteristics = 3000;
/// Returns whether the solver first tries transport along characteristics.
bool are_characteristics_preferred(const problem::Problem& problem, double impulses_per_decay_time);
/// Returns whether upwind differences cannot resolve the density, because the density is unbounded
/// or concentrated on a limit cycle, or because flights between impacts are shorter than a cell.
bool are_characteristics_required(const problem::Problem& problem);

/// Automatic order of the finite-volume scheme for a density with several length scales, without
/// losses at a wall. Without losses at a wall, order 7 with wider cells is more accurate than order
/// 5 at equal cost (docs/performance.md).
inline constexpr int kHighFiniteVolumeOrder = 7;
/// Factor by which the cells of a scheme of order kHighFiniteVolumeOrder are wider than the cells
/// of a scheme of lower order
inline constexpr double kCellWidthFactorOfHighOrder = 1.2;
int automatic_scheme_order(const problem::Problem& problem);

/// Returns the factor by which the option FiniteVolumeOptions::wall_density is multiplied for the
/// stationary density on upwind grids, for problems without has_linearised_scales().
double box_edge_density_factor(const problem::Problem& problem);

/// Limits of the error indicators within which the grid resolves the density.
struct DensityResolutionLimits {
  double min_density;  ///< smallest accepted density relative to the peak, <= 0
  double power;        ///< largest accepted |residual| of the power balance, relative to the input

  /// is_density_accepted() and is_power_residual_accepted() return false for the argument NaN.
  bool is_density_accepted(double relative_min_density) const {
    return relative_min_density >= min_density;
  }
  bool is_power_residual_accepted(double residual) const { return std::abs(residual) <= power; }
};

/// Limits of the error indicators beyond which an automatic grid is refined. The limits of
/// automatic refinement are stricter than the limits of the status `ok`,
/// kStationaryResolutionLimits (stationary/status_checks.hpp), to leave a margin.
inline constexpr DensityResolutionLimits kAutomaticGridResolutionLimits{.min_density = -1e-5,
                                                                        .power = 5e-4};

/// Returns whether a finer grid would not make the density nonnegative, since with the impact
/// condition to first order in 1-r the stationary density is negative at some points.
/// @param min_density smallest cell average of the density, relative to the peak density
bool has_negative_density_on_all_grids(const FiniteVolumeOptions& options, double min_density);

/// Largest L1 error estimate at which the refinement of an automatic grid stops; the time limit may
/// stop the refinement earlier.
inline constexpr double kAutomaticGridTargetL1Error = 1e-4;

/// Returns whether the status `ok` requires small residuals of the balances (kMaxBalanceResidual)
/// and a refinement of the grid until the status is `ok`. Small residuals of the balances are
/// required for problems for which possibly no other method would reveal a wrong density.
bool must_satisfy_balances(const problem::Problem& problem);

/// Returns whether the options permit the solver to choose finer grids.
bool has_automatic_grid(const FiniteVolumeOptions& options);

/// Returns whether rare impulses make the joint density unbounded at the rest point.
bool is_density_unbounded_at_origin(const problem::Problem& problem);

/// Returns whether the relative discontinuity 1/r^2 - 1 of the density at a wall, with the
/// restitution coefficient r, exceeds a tenth.
bool has_dissipative_impacts(const std::optional<problem::Wall>& wall);

/// Default ratio of the cell width far from the origin to the cell width at the origin
inline constexpr double kOriginRefinement = 16;
/// Default ratio of the cell widths in the velocity x2 far from and at x2 = 0, under white noise
/// with losses at the impact. Under white noise the density at the wall is proportional to u^-beta
/// at the speed u. For schemes of order 3 and 5, the length CellGrading::core of x1 is at most the
/// cube of the length CellGrading::core of x2, divided by the noise coefficient D2.
inline constexpr double kOriginRefinementUnderWhiteNoise = 32;

/// Default ratio of the cell widths in the velocity x2 far from and at x2 = 0, if the force is
/// discontinuous at x2 = 0, without losses at a wall. A discontinuity of the force reduces the
/// order of convergence to about 4. For 0.2 sign(v) + y under white noise of intensity 0.2 the
/// residual of the power balance on the first grid is 7e-6 with this ratio, and 6e-5 with the ratio
/// 2 (`fpkcheck fd --origin-refinement 2`); with the ratio 1 the solution on the first grid does
/// not have the status `ok`.
inline constexpr double kForceJumpRefinement = 4;

/// Returns options.origin_refinement, or the default ratio of cell widths if the option is not set.
double effective_origin_refinement(const problem::Problem& problem,
                                   const FiniteVolumeOptions& options);

/// Length scales of the density in x1 and in x2; 0 for a length scale that is not yet determined.
struct DensityLengthScales {
  double x1 = 0, x2 = 0;
};

/// Gradings of the cell widths in the displacement x1 towards walls, in the velocity x2 towards 0.
struct GridCellGradings {
  CellGrading x1, x2;
  bool at_left_wall = false, at_right_wall = false;
};
GridCellGradings automatic_gradings(const problem::Problem& problem,
                                    const FiniteVolumeOptions& options,
                                    const DensityLengthScales& lengths);

/// Returns the default cell widths in x1 and x2 far from all refinement points.
DensityLengthScales automatic_cell_widths(const problem::Problem& problem,
                                          const FiniteVolumeOptions& options,
                                          const DensityLengthScales& lengths);

}  // namespace fpkcheck::fd_fpk
