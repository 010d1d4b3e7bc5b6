#pragma once

#include <string>
#include <vector>

#include "workflows/sweep/report/figure/key_axis.hpp"

namespace fpkcheck::sweep {

/// Points that a curve runs through, in the order of the key along which it runs.
struct Slice {
  std::string name;  ///< the value of another key, "gaussian"; may be empty
  std::vector<std::size_t> points;
};

/// Curves of all methods along one key, in a row of panels for each slice.
struct CurvesLayout {
  KeyAxis along;
  std::size_t place;  ///< of that key among the plan's axes
  std::vector<Slice> slices;
};

/// Curves along the only key, or along the numeric one of two, with a slice for each word of the
/// other.
CurvesLayout curves_layout(const Plan& plan);

}  // namespace fpkcheck::sweep
