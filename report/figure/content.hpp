#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "report/figure/ranges.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The curves of a marginal density, in drawing order.
struct MarginalCurves {
  transform::Variable variable;
  std::vector<DrawnCurve> curves;
  /// Ranges over the solutions with status ok, or over all solutions if none is ok. The ranges of
  /// the differences are those of difference_ranges.
  FigureRanges ranges;
};

/// The content of the figure of a case. Holds pointers into the case.
struct FigureContent {
  /// Id of the solution subtracted from all others (compare::reference), or "".
  std::string reference;
  /// Whether differences are between averages over smooth bins. There the reference has small
  /// errors, and absolute differences are shown on a logarithmic axis.
  bool smooth_differences = false;
  std::vector<MarginalCurves> marginals;  ///< y and ydot, without a marginal that has no curve
  std::size_t hidden_count = 0;           ///< number of solutions with curves that are not shown
};

/// Ranges of the differences of these curves. A logarithmic axis contains the differences of all
/// curves, a linear axis only those of solutions that are ok or inaccurate, since a single outlier
/// would flatten the others. Without such solutions the ranges contain all curves.
FigureRanges difference_ranges(std::span<const DrawnCurve> curves, bool logarithmic);

/// The curves of a case.
/// @param shown ids of the solutions to show; all solutions if not given
FigureContent figure_content(const results::Case& case_result,
                             const std::optional<std::set<std::string>>& shown = {});

}  // namespace fpkcheck::report
