#pragma once

#include "backward/control/control_functions.hpp"
#include "backward/control/usual_control.hpp"
#include "numerics/splines/knot_splines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Splines for any problem, chosen by its scales (problem/scales.hpp) alone: of y from wall to wall,
/// or to where the energy-averaged density is exp(-9^2/2) of its peak if that is nearer, of y' a half
/// farther than where it is exp(-7^2/2), both wider where single impulses reach farther. Cells are of
/// about one width, wider towards an open end, and shrink towards walls and, where there are walls,
/// towards v = 0, where grazing impacts leave a corner and the knot is triple.
/// @param cells those of y count where the motion reaches to one side of a wall; twice as many where
/// there is no wall
ControlSplines general_splines(const problem::Problem& problem, const ControlCells& cells);

/// The fit on such splines under the weight
///
///     w(y, v) = exp(-(U(y) - lambda E[Y] y) / T) exp(-v^2 / 2T),   T = 2 variances of y'
///     (0.7 where there are several wells),
///
/// 1 where it is largest; each factor is no less than 1e-9.
/// @param problem, y, v referred to by the result
ControlProblem general_control(const problem::Problem& problem, const numerics::KnotSplines& y,
                               const numerics::KnotSplines& v, double wall_weight);

}  // namespace fpkcheck::backward
