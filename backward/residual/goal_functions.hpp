#pragma once

#include <vector>

#include "backward/control/control_fit_paper_class.hpp"
#include "backward/control/control_functions.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Splines for the solutions of the backward equation that weight the residuals. Errors of
/// densities concentrate where impacts are slow and the motion has decayed. In these regions the
/// cells are narrower by a factor of 40. The ends and the triple knot at v = 0 are those of
/// control_splines_paper_class(). If the mean of the impulses keeps the oscillator off the wall,
/// the splines are control_splines_paper_class(). Outside the paper's class the splines are
/// control_splines_any_oscillator().
ControlSplines residual_splines(const problem::Problem& problem, const ControlCells& cells);

/// The goal functions: functions of the phase plane whose expectations have error estimates.
struct GoalFunctions {
  /// All goal functions in this order: transform::kMoments (in physical coordinates), bins of y,
  /// bins of v.
  std::vector<SeparableFunction> all;
  int moments = 0, y_bins = 0, v_bins = 0;
};

/// The goal functions that belong to given splines. The bins are the B-splines on pairs of cells.
/// The sum of the bins is 1, the bins are narrow where the cells are narrow, and the solution of
/// the backward equation for a bin is smooth on the scale of the cells.
/// @param frame coordinate frame of the splines
GoalFunctions goal_functions(const numerics::QuinticBSplines& y, const numerics::QuinticBSplines& v,
                             const problem::Frame& frame = {});

}  // namespace fpkcheck::backward
