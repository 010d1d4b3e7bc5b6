#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "report/figure/axis_ranges.hpp"
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

/// The curves, axis ranges and reference of the figure of the marginal densities of a case. The
/// curves refer to objects of the case result.
struct DensityFigureContent {
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
/// @param shown_ids ids of the solutions whose curves are drawn; without a set, all curves are
/// drawn
DensityFigureContent density_content_for_picture(
    const results::CaseResult& case_result,
    const std::optional<std::set<std::string>>& shown_ids = {});

/// Returns the content of the plots of a case on the report page. The page initially hides the
/// curves of all solutions except `visible_ids`.
/// @param visible_ids ids of the solutions that are initially visible
DensityFigureContent density_content_for_page(const results::CaseResult& case_result,
                                              const std::set<std::string>& visible_ids);

}  // namespace fpkcheck::report
