#pragma once

#include <string>
#include <vector>

#include "workflows/sweep/report/figure/key_axis.hpp"

namespace fpkcheck::sweep {

/// Points of one curve, in the order of the key along the abscissa.
struct Slice {
  std::string name;  ///< value of the other key, e.g. "gaussian"; may be empty
  std::vector<std::size_t> points;
};

/// Layout of the curves of all methods along one key, with a row of panels for each slice.
struct CurvesLayout {
  KeyAxis along;
  std::size_t place;  ///< index of that key in the plan's axes
  std::vector<Slice> slices;
};

/// Curves along the only key; or along the numeric key of two, with a slice for each word of the
/// other.
CurvesLayout curves_layout(const Plan& plan);

}  // namespace fpkcheck::sweep
