#pragma once

#include "backward/control/control_fit_paper_class.hpp"
#include "backward/control/control_functions.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Splines of the control functions for any problem, determined by the scales of the problem alone
/// (problem/scales.hpp).
/// - The range of y extends from wall to wall, but not beyond the points where the energy-averaged
///   density is exp(-9^2/2) of its peak.
/// - The range of y' extends to 1.5 times the velocity where the energy-averaged density is
///   exp(-7^2/2) of its peak.
/// - Both ranges are wider if a single impulse moves the oscillator farther.
/// - The cells have about equal widths. They are wider towards an open end and narrower towards
///   walls. With walls the cells are also narrower towards v = 0, where grazing impacts cause a
///   corner of h and the knot is triple.
/// @param cells numbers of cells; without a left wall y has twice the given number of cells
ControlSplines control_splines_any_oscillator(const problem::Problem& problem,
                                              const ControlCells& cells);

/// The fit of the control functions on splines of y and v, with the weight
///
///     w(y, v) = exp(-(U(y) - lambda E[Y] y) / T) exp(-v^2 / 2T),   T = 2 variances of y'
///     (0.7 variances with several wells),
///
/// normalised to 1 at its maximum; each factor is at least 1e-9.
/// @param problem, y, v must outlive the returned fit, which refers to them
ControlFitProblem control_fit_any_oscillator(const problem::Problem& problem,
                                             const numerics::QuinticBSplines& y,
                                             const numerics::QuinticBSplines& v,
                                             double wall_weight);

}  // namespace fpkcheck::backward
