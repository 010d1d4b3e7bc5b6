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
  /// Axis ranges that contain the curves of all `ok` solutions (without an `ok` solution all
  /// curves), and the differences of all visible curves from the reference.
  MarginalAxisRanges ranges;
};

/// The content of the figure of a case. The curves refer to objects of the case result.
struct FigureContent {
  /// Id of the reference, which is subtracted from all other solutions; empty without a reference.
  std::string reference;
  /// Whether the figure shows differences between averages over smooth bins (B-spline weights).
  /// These differences have small errors and are shown on a logarithmic axis.
  bool smooth_differences = false;
  /// Lower end of the logarithmic density axes, unless all densities are larger.
  double smallest_density = kSmallestDrawnDensity;
  /// Marginal densities of y and y' that have at least one curve.
  std::vector<MarginalCurves> marginals;
  std::size_t hidden_count = 0;  ///< number of solutions whose curves the figure omits
};

/// Returns the content of the figure of a case: curves, axis ranges and reference.
/// @param shown ids of the solutions to show; an empty set selects all solutions
FigureContent figure_content(const results::CaseResult& case_result,
                             const std::optional<std::set<std::string>>& shown = {});

/// Returns the content of the plots of a case on the report page. Some of the curves are initially
/// hidden.
/// @param visible ids of the solutions that are initially visible
FigureContent page_content(const results::CaseResult& case_result,
                           const std::set<std::string>& visible);

}  // namespace fpkcheck::report
