#pragma once

#include <string>

#include "fd_fpk/operator/fokker_planck_operator.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Box of the phase plane in which the density is computed; each impact wall is an end of the box.
struct Box {
  double x1_max;
  double x2_max;
  double x1_min = 0;
  LengthScales lengths = {};  ///< units of the cell widths; 0 selects standard deviations as units
};

/// Maximum number of cells of a grid. With kMaxCells cells the factors of the preconditioner and
/// the vectors of GMRES take about two gigabytes of memory.
inline constexpr int kMaxCells = 100000;

struct Discretisation {
  Grid grid;
  Excitation excitation;
  /// regularisation length l of km4 that was used; 0 for other equations
  double regularisation_length = 0;
  /// Reason why no grid exists, and what to do; empty if a grid exists
  std::string failure = {};
  double cells = 0;  ///< number of cells of the grid; without a grid, the required number of cells
};

/// Returns the grid and the excitation discretised on the grid. The cell widths are about 1/7 (x1)
/// and 1/6 (x2) of a standard deviation, or of a length scale of the box. On a graded grid the
/// cells far from the origin are 1.6 times as wide as the cells of a uniform grid. If the force has
/// kinks in x1, the cells of x1 are narrower where the spring is stiffer.
Discretisation discretise(const problem::Problem& problem, const Options& options, const Box& box);

/// Box, and the numbers of cells of the grid in the box.
struct EnlargedBox {
  Box box;
  int nx;
  int nv;
};
/// Returns the box of the grid enlarged by about the given factors, without changing the cells
/// inside the given grid.
EnlargedBox enlarge_box(const problem::Problem& problem, const Options& options, const Grid& grid,
                        double factor_x1, double factor_x2);

/// Returns a discretisation with the grid of `discretisation` and the excitation of another
/// problem.
Discretisation with_excitation_of(const problem::Problem& problem, const Options& options,
                                  const Discretisation& discretisation);

FokkerPlanckOperator fokker_planck_operator(const problem::Problem& problem, const Options& options,
                                            const Discretisation& discretisation);

/// Excitation on a uniform velocity axis, as input of fastest_growing_wave(). The axis is so long
/// that the middle row of the excitation matrix equals the row for an unbounded axis.
struct UnboundedAxisExcitation {
  Axis axis;
  Excitation excitation;
};
UnboundedAxisExcitation unbounded_axis_excitation(const problem::Problem& problem,
                                                  const Options& options, double cell_width);

/// Returns the box before the solver moves ends outwards; ends that the options set are kept. In x1
/// the box extends over 6 standard deviations of equivalent linearisation from the static
/// deflection. In x2 the box extends over 7 standard deviations of equivalent linearisation, and at
/// least 6.5 standard deviations of a single impulse. Without has_linearised_scales() the box has
/// the limits of problem::MotionScales, or ends at the walls.
Box initial_box(const problem::Problem& problem, const Options& options);
Box initial_box(const problem::Problem& problem, const problem::MotionScales& scales,
                const Options& options);

/// Returns the length scales l of a density on a coarse grid from the Fisher information, l^-2 =
/// E[(d ln p/dx)^2]. The length scales of a normal density are the standard deviations. A density
/// with several peaks or a ring has length scales below the standard deviations.
/// In x1 the derivative is taken in the coordinate in which the cells of the box have equal widths.
LengthScales fisher_length_scales(const problem::System& system, const Box& box, const Grid& grid,
                                  const Eigen::VectorXd& averages,
                                  const problem::MotionScales& scales);

}  // namespace fpkcheck::fd_fpk
