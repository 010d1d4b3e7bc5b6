#pragma once

#include <vector>

#include "backward/control/control_functions.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/walls.hpp"

namespace fpkcheck::backward {

/// Functions of the phase plane whose expectations have error estimates.
struct GoalFunctions {
  /// All goal functions in this order: transform::kMoments (in physical coordinates), bins of y,
  /// bins of v
  std::vector<SeparableFunction> all;
  int moments = 0, y_bins = 0, v_bins = 0;
};

/// Returns the goal functions for given splines. The bins are B-splines whose cells are pairs of
/// cells of the given splines, with the sum 1. The bins are narrow where the cells are narrow, and
/// the solution of the backward equation for a bin is smooth on the scale of the cells.
/// @param frame coordinate frame of the splines
GoalFunctions goal_functions(const numerics::QuinticBSplines& y, const numerics::QuinticBSplines& v,
                             const problem::WallFrame& frame = {});

}  // namespace fpkcheck::backward
