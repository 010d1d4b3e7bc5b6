#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "report/figure/ranges.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The curves of one variable, in drawing order.
struct FigureSide {
  transform::Variable variable;
  std::vector<DrawnCurve> curves;
  /// Ranges of the solutions that are ok, or of all when none is; those of differences are of
  /// difference_ranges.
  FigureRanges ranges;
};

/// What the figure of one case shows. Points into the case.
struct FigureContent {
  /// Id of the solution that the others are subtracted from (compare::reference), or "".
  std::string reference;
  /// Whether differences are those of averages over smooth bins, which the reference knows so well
  /// that their sizes are shown, on a logarithmic axis.
  bool smooth_differences = false;
  std::vector<FigureSide> sides;  ///< y and ydot, without a side that has no curve
  std::size_t left_out = 0;  ///< solutions that have curves and are not shown: a legend counts them
};

/// Ranges of the differences of these curves: a logarithmic axis holds the differences of all curves, a
/// linear axis only those of solutions that are ok or inaccurate, as one wild curve would flatten the
/// others. Without such solutions the ranges hold all curves.
FigureRanges difference_ranges(std::span<const DrawnCurve> curves, bool logarithmic);

/// @param shown ids of the solutions to show; without it all
FigureContent figure_content(const results::Case& one,
                             const std::optional<std::set<std::string>>& shown = {});

}  // namespace fpkcheck::report
