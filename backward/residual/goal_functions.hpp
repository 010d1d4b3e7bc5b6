#pragma once

#include <vector>

#include "backward/control_variates/control_variate_functions.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/walls.hpp"

namespace fpkcheck::backward {

/// Goal functions f: functions of the state whose expectations E_p[f] have error estimates.
struct GoalFunctions {
  /// The goal functions in the order: transform::kMoments (in physical coordinates), smooth bins of
  /// y, smooth bins of v
  std::vector<SeparableFunction> functions;
  int moment_count = 0, y_bin_count = 0, v_bin_count = 0;
};

/// Makes the goal functions, moments and smooth bins, for given splines. The smooth bins of y, and
/// those of v, are B-splines with the sum 1. Each cell of a smooth bin consists of two cells of the
/// given splines, so that the bins are narrow where the spline cells are narrow. The solution of
/// the backward equation for a smooth bin of two spline cells is smooth on the scale of the spline
/// cells.
/// @param frame coordinate frame of the splines
GoalFunctions make_goal_functions(const numerics::QuinticBSplines& y_splines,
                                  const numerics::QuinticBSplines& v_splines,
                                  const problem::WallFrame& frame = {});

}  // namespace fpkcheck::backward
