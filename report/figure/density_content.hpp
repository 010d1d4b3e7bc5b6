#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "results/run.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::report {

/// Smallest densities on the logarithmic axes of pictures (as in the paper's figures) and of the
/// report page.
inline constexpr double kSmallestDrawnDensity = 1e-6, kSmallestDensityOnPage = 1e-7;

/// The axis ranges of the panels of one marginal density.
struct MarginalAxisRanges {
  double linear_from, linear_to;  ///< range of abscissae where a density exceeds linear_top/500
  double logarithmic_from, logarithmic_to;  ///< range where a density exceeds kSmallestDrawnDensity
  double linear_top;                        ///< largest density outside the narrow bins at a spike
  double largest_density;                   ///< largest density over all bins
  double least_density;                     ///< smallest density over all bins; 0 with an empty bin
  /// Largest difference of a density from the reference density, with confidence intervals but
  /// without narrow bins; 0 without a reference.
  double largest_difference;
  double least_difference;  ///< smallest among the maxima of the difference curves
};

/// The difference between a density curve and the curve of the reference solution. With averages
/// over smooth bins (B-spline weights) the stored values are absolute differences. For the
/// reference solution the stored values are the half-widths of its 95 % confidence intervals, below
/// which differences are not significant.
struct CurveDifferenceFromReference {
  std::vector<double> abscissa, values;
  std::vector<double> lower, upper;  ///< ends of 95 % confidence intervals; may be empty

  bool empty() const { return values.empty(); }
};

/// A density curve of a figure, drawn in the plot style of its solution.
struct DrawnDensityCurve {
  const transform::Solution* solution;
  const results::DensityCurve* curve;
  CurveDifferenceFromReference difference;  ///< difference from the reference; may be empty
  std::size_t rank = 0;                     ///< position of the solution in the tables
  bool is_hidden = false;                   ///< whether the page initially hides the curve

  /// Returns for each bin of the density whether the bin has the regular width. Bins narrower than
  /// the regular width resolve a spike of the density (compare::comparison_bins), whose large
  /// values would compress all other values on an axis.
  std::vector<bool> undivided_bin_flags() const;

  const transform::PlotStyle& plot_style() const { return solution->identity.plot_style; }
};

/// Returns the range of the logarithmic axis of density differences, at most eight whole decades.
/// The axis of density differences ends at the largest difference and begins two decades below the
/// smallest among the maxima of the difference curves.
std::pair<double, double> difference_axis_decades(const MarginalAxisRanges& ranges);

/// Returns the lower end of the logarithmic axis of a density. The lower end of the density axis is
/// a power of ten below all densities, at least one decade below the upper end, and at least
/// `floor`.
double logarithmic_axis_bottom(const MarginalAxisRanges& ranges,
                               double floor = kSmallestDrawnDensity);
/// Returns the upper end of the logarithmic axis of a density, above the peak of the density.
inline double logarithmic_axis_top(const MarginalAxisRanges& ranges) {
  return 3 * ranges.largest_density;
}

/// Returns a note on the height of a density spike that exceeds the linear axis; empty without such
/// a spike.
std::string density_spike_note(const MarginalAxisRanges& ranges);

/// Returns the axis ranges that contain all given density curves. Callers of density_axis_ranges()
/// should pass only the curves of reliable solutions, since a single outlier would compress all
/// other curves.
MarginalAxisRanges density_axis_ranges(std::span<const DrawnDensityCurve> curves);

/// The curves of all solutions for one marginal density, in drawing order.
struct MarginalDensityCurves {
  transform::StateVariable variable;
  std::vector<DrawnDensityCurve> curves;
  /// Axis ranges that contain the curves of all `ok` solutions (without an `ok` solution all
  /// curves), and the differences of all visible curves from the reference.
  MarginalAxisRanges ranges;
};

/// The curves, axis ranges and reference solution in the figure of the marginal densities of a
/// case. The curves of a DensityFigureContent refer to objects of the case result.
struct DensityFigureContent {
  /// Id of the reference solution, whose density is subtracted from all other densities; empty
  /// without a reference.
  std::string reference;
  /// Whether the figure shows differences between averages over smooth bins (B-spline weights).
  /// Differences of averages over smooth bins have small errors and are shown on a logarithmic
  /// axis.
  bool smooth_differences = false;
  /// Lower end of the logarithmic density axes, unless all drawn densities are larger.
  double smallest_density = kSmallestDrawnDensity;
  /// Marginal densities of y and y' that have at least one curve.
  std::vector<MarginalDensityCurves> marginals;
  std::size_t hidden_count = 0;  ///< number of solutions whose curves the figure omits
};

/// Returns the content of the density figure of a case: curves, axis ranges and reference solution.
/// @param shown_ids ids of the solutions whose curves are drawn; without a set, all curves are
///        drawn
DensityFigureContent density_content_for_picture(
    const results::CaseResult& case_result,
    const std::optional<std::set<std::string>>& shown_ids = {});

/// Returns the content of the density plots of a case on the report page. The report page initially
/// hides the curves of all solutions except `visible_ids`.
/// @param visible_ids ids of the solutions that are initially visible
DensityFigureContent density_content_for_page(const results::CaseResult& case_result,
                                              const std::set<std::string>& visible_ids);

}  // namespace fpkcheck::report
