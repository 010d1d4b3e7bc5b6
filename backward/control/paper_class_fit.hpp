#pragma once

#include "backward/control/control_functions.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Numbers of cells of the splines of y and of y'.
struct ControlCells {
  int y, v;
};

/// The splines of the control functions.
struct ControlSplines {
  numerics::QuinticBSplines y, v;
};

/// Splines for the base class, determined by the deviations of equivalent linearisation. The ends
/// are 9 deviations from the static deflection in y and 10.5 deviations to both sides in v; the
/// cells are uniform up to 5 and 6 deviations. The knot at v = 0 is triple, since grazing impacts
/// cause a corner of h there.
/// @param graded_cells number of cells that shrink towards the wall and towards v = 0 (graded_knots)
ControlSplines paper_class_splines(const problem::Problem& problem, const ControlCells& cells,
                                   int graded_cells = 0);

/// The fit on these splines with the weight
///
///     w(y, v) = exp(-(U(y) - lambda E[Y] y) / T) exp(-v^2 / 2T),   T = 2 variances of y',
///
/// normalised to 1 at its maximum; each factor is at least 1e-9. E[Y] counts only if positive,
/// directed off the wall.
/// @param problem, y, v the result refers to these
ControlFit paper_class_fit(const problem::Problem& problem, const numerics::QuinticBSplines& y,
                           const numerics::QuinticBSplines& v, double wall_weight);

}  // namespace fpkcheck::backward
