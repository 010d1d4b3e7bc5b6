#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "report/figure/ranges.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The curves of all solutions for one marginal density, in drawing order.
struct MarginalCurves {
  transform::StateVariable variable;
  std::vector<DrawnCurve> curves;
  /// Axis ranges that contain the curves of the solutions with status ok, or all curves if no
  /// solution is ok; and the differences of the curves that are not hidden.
  MarginalAxisRanges ranges;
};

/// The content of the figure of a case. The curves point to objects of the case.
struct FigureContent {
  /// Id of the reference, which is subtracted from all other solutions; empty without a reference.
  std::string reference;
  /// Whether the figure shows differences between averages over smooth bins (B-spline weights).
  /// These averages have small errors: their absolute differences are shown on a logarithmic axis.
  bool smooth_differences = false;
  /// The lower end of the logarithmic axes, unless all densities are larger.
  double smallest_density = kSmallestDrawnDensity;
  std::vector<MarginalCurves> marginals;  ///< y and ydot, without a marginal that has no curve
  std::size_t hidden_count = 0;           ///< number of solutions with curves that are not shown
};

/// The content of the figure of a case: curves, ranges and reference.
/// @param shown ids of the solutions to show; all solutions are shown if this argument is empty
FigureContent figure_content(const results::CaseResult& case_result,
                             const std::optional<std::set<std::string>>& shown = {});

/// The content of the plots of a case on the page: all curves, of which some are initially hidden.
/// @param visible ids of the solutions that are initially visible
FigureContent page_content(const results::CaseResult& case_result,
                           const std::set<std::string>& visible);

}  // namespace fpkcheck::report
