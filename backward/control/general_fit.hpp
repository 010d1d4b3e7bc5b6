#pragma once

#include "backward/control/control_functions.hpp"
#include "backward/control/paper_class_fit.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Splines for any problem, determined by its scales (problem/scales.hpp) alone.
/// - y: from wall to wall, but not beyond the points where the energy-averaged density is less
///   than exp(-9^2/2) of its peak.
/// - y': to 1.5 times the velocity at which that density is exp(-7^2/2) of its peak.
/// - Both are wider if single impulses lead farther.
/// - Cells have about equal widths, wider towards an open end, narrower towards walls and, with
///   walls, towards v = 0. There grazing impacts cause a corner of h, and the knot is triple.
/// @param cells number of cells of y on one side of a wall; twice that number without a left wall
ControlSplines general_splines(const problem::Problem& problem, const ControlCells& cells);

/// The fit on these splines with the weight
///
///     w(y, v) = exp(-(U(y) - lambda E[Y] y) / T) exp(-v^2 / 2T),   T = 2 variances of y'
///     (0.7 variances with several wells),
///
/// normalised to 1 at its maximum; each factor is at least 1e-9.
/// @param problem, y, v the result refers to these
ControlFit general_fit(const problem::Problem& problem, const numerics::QuinticBSplines& y,
                       const numerics::QuinticBSplines& v, double wall_weight);

}  // namespace fpkcheck::backward
