#pragma once

#include <string>
#include <vector>

#include "workflows/sweep/report/figure/key_axis.hpp"

namespace fpkcheck::sweep {

/// A slice of a plan: the points of one curve, in the order of the key on the abscissa.
struct PlanSlice {
  std::string name;  ///< value of the other key, e.g. "gaussian"; may be empty
  std::vector<std::size_t> points;
};

/// The layout of a figure with curves of all methods along one key. Each slice has a row of panels.
struct CurvesLayout {
  KeyAxis along;
  std::size_t place;  ///< index of that key in the plan's axes
  std::vector<PlanSlice> slices;
};

/// The layout of the curves of a plan. The curves of a plan with one key are along this key. The
/// curves of a plan with two keys are along the numeric key, with a slice for each value of the
/// categorical key.
CurvesLayout curves_layout(const Plan& plan);

}  // namespace fpkcheck::sweep
