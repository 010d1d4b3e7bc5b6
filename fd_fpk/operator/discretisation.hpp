#pragma once

#include <optional>
#include <string>

#include "fd_fpk/operator/operator.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {

/// Distances over which the density varies in either direction; 0 where not yet determined.
struct LengthScales {
  double x1 = 0, x2 = 0;
};

/// The box in which the density is computed. Impact walls are at its ends, where there are any.
struct Box {
  double x1_max;
  double x2_max;
  double x1_min = 0;
  LengthScales lengths = {};  ///< unit of the cell widths, outside the paper's class
};

/// Maximum number of cells of a grid: the factors of the preconditioner and the vectors of GMRES
/// then take about two gigabytes.
inline constexpr int kMostCells = 100000;

/// The grid and the excitation on it.
struct Discretisation {
  Grid grid;
  Excitation excitation;
  double regularisation_length = 0;  ///< l of km4 as used, else 0
  /// Reason for the absence of a grid, and what to do; empty when there is a grid.
  std::string failure = {};
  double cells = 0;  ///< number of cells of the grid, or the number it would need
};

/// True where the joint density is unbounded at rest (problem::impulses_per_decay_time).
bool is_unbounded_at_origin(const problem::Problem& problem);

/// True if there is a wall and the density's jump along it at x2 = 0, 1/r^2 - 1, exceeds a tenth.
bool has_significant_losses(const std::optional<problem::Wall>& wall);

/// True if a nonzero mean of the impulses keeps the oscillator so far off the wall that impacts are
/// rare.
bool is_held_off_wall(const problem::Problem& problem);

/// Automatic ratio of the cell width far out to the width at the origin, where the origin is
/// refined.
inline constexpr double kOriginRefinement = 16;
/// The same ratio for x2 under white noise with losses, where the density at the wall goes as
/// u^-beta and cells of x1 are graded as the cube of those of x2 (orders 3 and 5).
inline constexpr double kOriginRefinementUnderWhiteNoise = 32;

/// Automatic order outside the paper's class where no wall dissipates energy. There the density has
/// no jump along the orbit that grazes the wall, and this order with wider cells is more accurate
/// than order 5 at equal cost (docs/performance.md).
inline constexpr int kHighOrder = 7;
inline constexpr double kHighOrderWidthFactor = 1.2;

/// Automatic order of the transport terms for the stationary density.
int automatic_order(const problem::Problem& problem);

/// options.origin_refinement, or its automatic value.
double origin_refinement(const problem::Problem& problem, const Options& options);

/// Cells of about 1/7 (x1) and 1/6 (x2) of a standard deviation of equivalent linearisation, or of
/// the box's length scales; 1.6 times as wide far out on a graded grid. The options may set the
/// numbers of cells.
Discretisation discretise(const problem::Problem& problem, const Options& options, const Box& box);

/// A box and its numbers of cells.
struct BoxExtension {
  Box box;
  int nx;
  int nv;
};
/// A box enlarged by about these factors, with the same cells inside the given grid.
BoxExtension extend_box(const problem::Problem& problem, const Options& options, const Grid& grid,
                        double factor_x1, double factor_x2);

/// The operator of the options on their grid.
FokkerPlanckOperator fokker_planck_operator(const problem::Problem& problem, const Options& options,
                                            const Discretisation& on);

/// The excitation on a uniform velocity axis with this step, long enough that its middle row is the
/// operator without walls: the input of largest_growth. The regularisation length is that of the
/// options, or the default for cells of this step.
struct UnboundedExcitation {
  Axis axis;
  Excitation excitation;
};
UnboundedExcitation unbounded_excitation(const problem::Problem& problem, const Options& options,
                                         double step);

/// The box of the options. Else 6 (x1, from the static deflection) and 7 (x2) standard deviations
/// of equivalent linearisation, and at least 6.5 standard deviations of a single impulse in x2.
/// Outside the paper's class the limits of problem::Scales, and the walls.
Box initial_box(const problem::Problem& problem, const Options& options);
Box initial_box(const problem::Problem& problem, const problem::Scales& scales,
                const Options& options);

/// The length scales of a density on a coarse grid, by its Fisher information: l^-2 = E[(d ln
/// p/dx)^2]. For a normal density they are the standard deviations; they are shorter for several
/// wells or a ring, and never longer.
LengthScales fisher_length_scales(const Grid& grid, const Eigen::VectorXd& averages,
                                  const problem::Scales& scales);

}  // namespace fpkcheck::fd_fpk
