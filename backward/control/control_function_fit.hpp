#pragma once

#include "backward/control/control_functions.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

struct ControlCells {
  int y, v;
};

struct ControlSplines {
  numerics::QuinticBSplines y, v;
};

enum class CellWidths {
  /// Cells of equal width, for the control functions of the simulation
  /// @pre problem::has_equivalent_linearisation()
  even,
  /// Cells whose widths decrease towards walls and, with walls, towards v = 0, for the residuals of
  /// densities. Errors of densities concentrate at slow impacts and where the motion has decayed.
  narrower_at_walls
};

/// Returns the splines of the control functions, determined by the scales of the problem alone
/// (problem/motion_scales.hpp).
/// - The range of y extends from wall to wall, but not beyond the points where the energy-averaged
///   density is exp(-9^2/2) of its peak.
/// - The range of y' extends to 1.5 times the velocity where the energy-averaged density is
///   exp(-7^2/2) of its peak.
/// - The ranges of y and y' are widened if a single impulse moves the oscillator out of the ranges.
/// - The cells have about equal widths where the density is large and are wider towards an open
///   end.
/// - With walls the knot at v = 0 is triple, since grazing impacts cause a corner of the control
///   function h at v = 0.
/// @param cells numbers of cells; without a left wall y has twice the given number of cells
ControlSplines control_splines(const problem::Problem& problem, const ControlCells& cells,
                               CellWidths widths);

/// Returns the fit of the control functions on splines of y and v, with the weight
///
///     w(y, v) = exp(-(U(y) - lambda E[Y] y) / T) exp(-v^2 / 2T),   T = 2 variances of y'
///     (0.7 variances with several wells),
///
/// normalised to 1 at the maximum of the weight. Each factor of the weight is at least 1e-9.
/// @param problem, y, v must outlive the returned fit, which refers to them
ControlFitProblem control_function_fit(const problem::Problem& problem,
                                       const numerics::QuinticBSplines& y,
                                       const numerics::QuinticBSplines& v, double wall_weight);

}  // namespace fpkcheck::backward
