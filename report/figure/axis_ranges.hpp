#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "results/run.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::report {

/// Accumulates values by include() and computes the range of a logarithmic axis that contains all
/// these values. Values without a finite logarithm are ignored.
class LogAxisRange {
 public:
  void include(double value) {
    if (!(value > 0) || !std::isfinite(value)) return;
    least_ = std::min(least_, value);
    most_ = std::max(most_, value);
  }

  /// Returns the ends of the axis as exponents of ten. The margins are in decades. Without positive
  /// values the ends are -1 and 1.
  std::array<double, 2> exponents(double margin_below, double margin_above) const {
    if (most_ < least_) return {-1, 1};
    return {std::log10(least_) - margin_below, std::log10(most_) + margin_above};
  }

 private:
  double least_ = std::numeric_limits<double>::infinity(), most_ = 0;
};

/// Smallest density on logarithmic axes: of pictures, as in the paper's figures, and of the report
/// page.
inline constexpr double kSmallestDrawnDensity = 1e-6, kSmallestDensityOnPage = 1e-7;

/// The axis ranges of the panels of one marginal density.
struct MarginalAxisRanges {
  double linear_from, linear_to;  ///< range of abscissae where a density exceeds linear_top/500
  double logarithmic_from, logarithmic_to;  ///< range where a density exceeds kSmallestDrawnDensity
  double linear_top;                        ///< largest density outside the narrow bins at a spike
  double largest_density;                   ///< largest density over all bins
  double least_density;                     ///< smallest density over all bins; 0 with an empty bin
  /// Largest difference from the reference, including confidence intervals but not narrow bins; 0
  /// without a reference.
  double largest_difference;
  double least_difference;  ///< smallest among the maxima of the difference curves
};

/// The difference between a curve and the curve of the reference. Over smooth bins the values are
/// absolute differences. For the reference the values are the half-widths of its 95 % confidence
/// intervals, below which differences are not significant.
struct CurveDifference {
  std::vector<double> abscissa, values;
  std::vector<double> lower, upper;  ///< ends of 95 % confidence intervals; may be empty

  bool empty() const { return values.empty(); }
};

/// A curve of a figure, drawn in the plot style of its solution.
struct DrawnCurve {
  const transform::Solution* solution;
  const results::DensityCurve* curve;
  CurveDifference difference;  ///< difference from the reference; may be empty
  std::size_t rank = 0;        ///< position of the solution in the tables
  bool is_hidden = false;      ///< whether the page initially hides the curve

  /// Returns, for each bin, whether the bin has the regular width. Narrower bins resolve a spike of
  /// the density (compare::comparison_axes), whose large values would compress all other values on
  /// an axis.
  std::vector<bool> full_width_bin_flags() const;

  const transform::PlotStyle& plot_style() const { return solution->identity.plot_style; }
};

/// Returns the range of a logarithmic axis of differences, in at most eight whole decades. The
/// upper end of the axis is the largest difference. The lower end is two decades below the smallest
/// among the maxima of the difference curves.
std::pair<double, double> difference_axis_decades(const MarginalAxisRanges& ranges);

/// Returns the lower end of the logarithmic axis of a density. The lower end is a power of ten
/// below all values, at least one decade below the upper end of the axis, and at least `floor`.
double logarithmic_axis_bottom(const MarginalAxisRanges& ranges,
                               double floor = kSmallestDrawnDensity);
/// Returns the upper end of the logarithmic axis of a density, above the peak of the density.
inline double logarithmic_axis_top(const MarginalAxisRanges& ranges) {
  return 3 * ranges.largest_density;
}

/// Returns a note on the height of a spike of the density above the linear axis; empty without such
/// a spike.
std::string spike_note(const MarginalAxisRanges& ranges);

/// Returns the axis ranges that contain all given curves. Callers should pass only the curves of
/// reliable solutions, since a single outlier would compress all other curves.
MarginalAxisRanges density_axis_ranges(std::span<const DrawnCurve> curves);

}  // namespace fpkcheck::report
