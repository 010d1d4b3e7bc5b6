#pragma once

#include "backward/control/control_functions.hpp"
#include "numerics/splines/knot_splines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Numbers of cells of the splines of y and of y'.
struct ControlCells {
  int y, v;
};

/// The splines of the control functions.
struct ControlSplines {
  numerics::KnotSplines y, v;
};

/// Splines for the base class, determined by the deviations of equivalent linearisation. The ends
/// are 9 deviations from the static deflection in y and 10.5 deviations to both sides in v; the
/// cells are uniform up to 5 and 6 deviations. The knot at v = 0 is triple, since grazing impacts
/// cause a corner of h there.
/// @param shrinking number of cells that shrink towards the wall and towards v = 0 (widening_knots)
ControlSplines usual_splines(const problem::Problem& problem, const ControlCells& cells,
                             int shrinking = 0);

/// The fit on these splines with the weight
///
///     w(y, v) = exp(-(U(y) - lambda E[Y] y) / T) exp(-v^2 / 2T),   T = 2 variances of y',
///
/// normalised to 1 at its maximum; each factor is at least 1e-9. E[Y] counts only if positive,
/// directed off the wall.
/// @param problem, y, v the result refers to these
ControlProblem usual_control(const problem::Problem& problem, const numerics::KnotSplines& y,
                             const numerics::KnotSplines& v, double wall_weight);

}  // namespace fpkcheck::backward
