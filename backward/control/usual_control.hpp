#pragma once

#include "backward/control/control_functions.hpp"
#include "numerics/splines/knot_splines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Cells of the splines of y and of y'.
struct ControlCells {
  int y, v;
};

/// What control functions are made of.
struct ControlSplines {
  numerics::KnotSplines y, v;
};

/// Chosen for a problem alone, in deviations of equivalent linearisation: 9 in y, beyond where the
/// mean of the impulses holds the oscillator, and 10.5 to both sides in v, with cells of one width
/// up to 5 and 6 of them, and a triple knot at v = 0, where grazing impacts leave a corner.
/// @param shrinking cells next to the wall, and to v = 0, that shrink towards it (widening_knots)
ControlSplines usual_splines(const problem::Problem& problem, const ControlCells& cells,
                             int shrinking = 0);

/// The fit on these splines under the weight
///
///     w(y, v) = exp(-(U(y) - lambda E[Y] y) / T) exp(-v^2 / 2T),   T = 2 variances of y',
///
/// 1 where it is largest, with E[Y] only where impulses push away from the wall; each factor is no
/// less than 1e-9.
/// @param problem, y, v referred to by the result
ControlProblem usual_control(const problem::Problem& problem, const numerics::KnotSplines& y,
                             const numerics::KnotSplines& v, double wall_weight);

}  // namespace fpkcheck::backward
