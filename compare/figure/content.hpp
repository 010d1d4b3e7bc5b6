#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "compare/figure/ranges.hpp"

namespace fpkcheck::compare {

/// The curves of one variable, in drawing order.
struct FigureSide {
  std::string variable;  ///< "y" or "ydot"
  std::vector<DrawnCurve> curves;
  FigureRanges ranges;  ///< of the solutions that are ok, or of all when none is
};

/// What the figure of one case shows. Points into the summary and the curves it was made from.
struct FigureContent {
  std::string reference;          ///< id of the solution that the others are subtracted from, or ""
  std::vector<FigureSide> sides;  ///< y and ydot, without a side that has no curve
};

/// @param summary_case one element of "cases" in summary.json
/// @param curves the curves of this case; those of solutions that the summary does not know are
///               left out
FigureContent figure_content(const nlohmann::ordered_json& summary_case,
                             std::span<const MarginalCurve> curves);

}  // namespace fpkcheck::compare
