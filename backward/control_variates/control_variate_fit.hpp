#pragma once

#include "backward/control_variates/control_variate_functions.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Numbers of spline cells of the control functions along displacement y and along velocity v.
struct ControlVariateCellCounts {
  int y_cells, v_cells;
};

/// Splines A_i(y) and B_j(v) of the control functions h = sum_ij h_ij A_i(y) B_j(v).
struct ControlVariateSplines {
  numerics::QuinticBSplines y_splines, v_splines;
};

/// Distribution of the widths of the spline cells along y and along v.
enum class SplineCellWidthDistribution {
  /// Spline cells of equal width where the density is large, for control functions of simulations
  /// @pre problem::has_equivalent_linearisation()
  equal,
  /// Spline cells whose widths decrease towards walls and, with walls, towards v = 0, for the
  /// residuals of densities. Errors of densities concentrate at slow impacts and near rest.
  narrower_at_walls
};

/// Makes the splines of the control functions from the scales of the problem alone
/// (problem/motion_scales.hpp).
/// - The range of y extends from wall to wall, but not beyond the points where the energy-averaged
///   density is exp(-9^2/2) of its peak.
/// - The range of v extends to 1.5 times the velocity where the energy-averaged density is
///   exp(-7^2/2) of its peak.
/// - The ranges of y and v are widened if a single impulse moves the oscillator out of the ranges.
/// - The cells have about equal widths where the density is large, and widen towards an open end.
/// - With walls the knot at v = 0 is triple, since grazing impacts cause a corner of h.
/// @param cells numbers of cells; without a left wall y has twice the given number of cells
ControlVariateSplines make_control_splines(const problem::Problem& problem,
                                           const ControlVariateCellCounts& cells,
                                           SplineCellWidthDistribution widths);

/// Makes the least-squares problem of the control functions on given splines, with the weight
///
///     w(y, v) = exp(-(V(y) - lambda E[Y] y) / T) exp(-v^2 / 2T),   T = 2 variances of v
///     (0.7 variances with several wells),
///
/// where V is the potential of the force. The weight is normalised to 1 at its maximum, and each
/// factor of the weight is at least 1e-9.
/// @param problem, y_splines, v_splines must outlive the result, which refers to them
/// @param wall_jump_weight weight of the jumps at the walls
/// (ControlVariateFitProblem::wall_jump_weight)
ControlVariateFitProblem make_control_fit_problem(const problem::Problem& problem,
                                                  const numerics::QuinticBSplines& y_splines,
                                                  const numerics::QuinticBSplines& v_splines,
                                                  double wall_jump_weight);

}  // namespace fpkcheck::backward
