#pragma once

#include <string>

#include "fd_fpk/operator/operator.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {

/// The box of the phase plane in which the density is computed. Each impact wall is an end of the
/// box.
struct Box {
  double x1_max;
  double x2_max;
  double x1_min = 0;
  LengthScales lengths = {};  ///< units of the cell widths; 0 selects standard deviations as units
};

/// Maximum number of cells of a grid. With kMaxCells cells the factors of the preconditioner and
/// the vectors of GMRES take about two gigabytes of memory.
inline constexpr int kMaxCells = 100000;

/// The grid, and the excitation discretised on the grid.
struct Discretisation {
  Grid grid;
  Excitation excitation;
  /// regularisation length l of km4 that was used; 0 for other equations
  double regularisation_length = 0;
  /// The reason why there is no grid, and what to do; empty if there is a grid.
  std::string failure = {};
  double cells = 0;  ///< number of cells of the grid, or the number that the grid would need
};

/// The grid and the excitation on the grid. The cell widths are about 1/7 (x1) and 1/6 (x2) of a
/// standard deviation of equivalent linearisation, or of the length scales of the box. On a graded
/// grid the cells far from the origin are 1.6 times as wide. The options may set the numbers of
/// cells.
Discretisation discretise(const problem::Problem& problem, const Options& options, const Box& box);

/// A box and the numbers of cells of its grid.
struct BoxExtension {
  Box box;
  int nx;
  int nv;
};
/// Returns the box of the grid enlarged by about the given factors. The extension does not change
/// the cells inside the given grid.
BoxExtension extend_box(const problem::Problem& problem, const Options& options, const Grid& grid,
                        double factor_x1, double factor_x2);

/// The Fokker-Planck operator of the options on the given grid.
FokkerPlanckOperator fokker_planck_operator(const problem::Problem& problem, const Options& options,
                                            const Discretisation& on);

/// The excitation on a uniform velocity axis, as input of fastest_growing_wave. The axis has cells
/// of the given width and is so long that the middle row of the excitation matrix contains no
/// stencils of the ends, and is thus the row for an unbounded axis. The options set the
/// regularisation length; its default depends on the cell width.
struct ExcitationWithoutWalls {
  Axis axis;
  Excitation excitation;
};
ExcitationWithoutWalls excitation_without_walls(const problem::Problem& problem,
                                                const Options& options, double cell_width);

/// The box before the solver moves its ends outwards. Ends of the box that the options set are
/// kept. The automatic box extends over 6 standard deviations of equivalent linearisation in x1,
/// from the static deflection, and over 7 in x2, and over at least 6.5 standard deviations of a
/// single impulse in x2. Without has_linearised_scales() the box has the limits of
/// problem::MotionScales, or ends at the walls.
Box initial_box(const problem::Problem& problem, const Options& options);
Box initial_box(const problem::Problem& problem, const problem::MotionScales& scales,
                const Options& options);

/// The length scales of a density on a coarse grid, from the Fisher information of the density:
/// l^-2 = E[(d ln p/dx)^2]. The length scales of a normal density are its standard deviations. For
/// every other density, such as a density with several peaks or a ring, the length scales are
/// shorter than the standard deviations.
LengthScales fisher_length_scales(const Grid& grid, const Eigen::VectorXd& averages,
                                  const problem::MotionScales& scales);

}  // namespace fpkcheck::fd_fpk
