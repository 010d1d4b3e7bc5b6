#pragma once

#include <optional>
#include <string>

#include "fd_fpk/operator/operator.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {

/// Over how much the density changes in either direction; 0 where nobody has looked.
struct Lengths {
  double x1 = 0, x2 = 0;
};

/// The box in which the density is sought: impact walls stand at its ends, where there are any.
struct Box {
  double x1_max;
  double x2_max;
  double x1_min = 0;
  Lengths lengths = {};  ///< what cells are fractions of, beyond the paper's class
};

/// Most cells of a grid: the factors of the preconditioner and GMRES's vectors then take about two
/// gigabytes.
inline constexpr int kMostCells = 100000;

/// The grid and the excitation on it.
struct Discretisation {
  Grid grid;
  Excitation excitation;
  double regularisation_length = 0;  ///< l of km4 as used, else 0
  /// Why there is no such grid and what to do; empty when there is one.
  std::string refusal = {};
  double cells = 0;  ///< that it has, or would have
};

/// True where the joint density is unbounded at rest (problem::impulses_per_decay_time).
bool unbounded_at_origin(const problem::Problem& problem);

/// There is such a wall, and the density's jump along it at x2 = 0, 1/r^2 - 1, is more than a tenth.
bool loses(const std::optional<problem::Wall>& wall);

/// The mean of the impulses holds the oscillator so far off the wall that it hardly meets it.
bool off_the_wall(const problem::Problem& problem);

/// How much narrower cells are at the origin where it is refined without being asked to.
inline constexpr double kRefinedOrigin = 16;
/// The same in x2 under white noise with losses, where the density at the wall goes as u^-beta and
/// cells of x1 are graded as the cube of those of x2 (orders 3 and 5).
inline constexpr double kOriginUnderWhiteNoise = 32;

/// Beyond the paper's class, where no wall takes energy and the density has no jump along the orbit that
/// grazes it, this order is worth more than its price, and so wider automatic cells
/// (docs/performance.md).
inline constexpr int kHighOrder = 7;
inline constexpr double kWidthOfHighOrder = 1.2;

/// Of the transport terms of the stationary density, where the options leave it open.
int automatic_order(const problem::Problem& problem);

/// options.origin_refinement, or the automatic choice.
double origin_refinement(const problem::Problem& problem, const Options& options);

/// Cells of about 1/7 (x1) and 1/6 (x2) of a deviation of equivalent linearisation, or of the box's
/// lengths, wider by 1.6 far out on a graded grid, unless the options set their number.
Discretisation discretise(const problem::Problem& problem, const Options& options, const Box& box);

/// A box, and cells that it is cut into.
struct Extent {
  Box box;
  int nx;
  int nv;
};
/// About so much further than a grid of these options reaches, on the same cells within.
Extent beyond(const problem::Problem& problem, const Options& options, const Grid& grid,
              double factor_x1, double factor_x2);

/// The operator that the options ask for on their grid.
FokkerPlanckOperator fokker_planck_operator(const problem::Problem& problem, const Options& options,
                                            const Discretisation& on);

/// The excitation on a uniform velocity line of this step, long enough that its middle row is the
/// operator without walls: what largest_growth scans. The regularisation length is that of the
/// options, or the default on cells of this step.
struct UnboundedExcitation {
  Line line;
  Excitation excitation;
};
UnboundedExcitation unbounded_excitation(const problem::Problem& problem, const Options& options,
                                         double step);

/// What the options say of the box, else 6 (x1, beyond the static deflection) and 7 (x2) deviations
/// of equivalent linearisation, and 6.5 deviations of a single impulse in x2. Beyond the paper's
/// class to where problem::Scales end, and to the walls.
Box initial_box(const problem::Problem& problem, const Options& options);
Box initial_box(const problem::Problem& problem, const problem::Scales& scales,
                const Options& options);

/// The lengths of a density on a coarse grid, by its Fisher information: l^-2 = E[(d ln p/dx)^2].
/// They are the deviations of what is normal, and less in several wells or on a ring; never more.
Lengths lengths_of(const Grid& grid, const Eigen::VectorXd& averages,
                   const problem::Scales& scales);

}  // namespace fpkcheck::fd_fpk
