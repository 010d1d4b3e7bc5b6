#pragma once

#include <vector>

#include "backward/control/control_functions.hpp"
#include "backward/control/usual_control.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Splines for a problem's backward equations as residuals need them. A density's faults lie where
/// impacts are slow and motion dies out; there cells are a fortieth as wide as elsewhere. Ends and
/// the triple knot at v = 0 are those of usual_splines, and so is all where the mean of the impulses
/// holds the oscillator off the wall. Beyond the paper's class they are general_splines.
ControlSplines residual_splines(const problem::Problem& problem, const ControlCells& cells);

/// What of a density is judged, as functions of the phase plane.
struct JudgedFunctions {
  /// transform::kMoments (of the physical coordinates), then bins of y, then bins of v.
  std::vector<SeparableFunction> all;
  int moments = 0, y_bins = 0, v_bins = 0;
};

/// Bins are the B-splines whose cells are each two of the given ones: they sum to 1, are narrow
/// where the cells are, and the backward equation of each is smooth on the scale of the cells.
/// @param frame in which the axes of the splines lie
JudgedFunctions judged_functions(const numerics::KnotSplines& y, const numerics::KnotSplines& v,
                                 const problem::Frame& frame = {});

}  // namespace fpkcheck::backward
