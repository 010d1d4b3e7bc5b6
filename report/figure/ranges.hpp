#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "results/run.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::report {

/// The smallest density on the logarithmic panels, as in the paper.
inline constexpr double kSmallestDrawnDensity = 1e-6;

/// Axis ranges of the panels of one marginal.
struct FigureRanges {
  double linear_from, linear_to;            ///< where a density exceeds 1/500 of linear_top
  double logarithmic_from, logarithmic_to;  ///< where a density exceeds kSmallestDrawnDensity
  double linear_top;          ///< the largest density, excluding the narrow bins at a spike
  double largest_density;     ///< over all bins
  double least_density;       ///< over all bins; 0 with an empty bin
  double largest_difference;  ///< from the reference, excluding narrow bins; 0 without reference
  double least_difference;    ///< the smallest maximum of a curve of differences
};

/// The difference of a curve from that of the reference. Over smooth bins the absolute difference,
/// and for the reference the half-width of its 95 % confidence intervals, the limit of
/// significance.
struct Difference {
  std::vector<double> abscissa, values;
  std::vector<double> lower, upper;  ///< ends of 95 % confidence intervals; may be empty

  bool empty() const { return values.empty(); }
};

/// A curve of a figure, drawn in the style of its solution.
struct DrawnCurve {
  const transform::Solution* solution;
  const results::Curve* curve;
  Difference difference;  ///< from the curve of the reference; empty without reference

  /// Flags the bins of regular width. The axes divide bins at a spike into narrow bins
  /// (compare::comparison_axes), whose large densities would compress all other values.
  std::vector<bool> broad_bins() const;

  const transform::PlotStyle& plot_style() const { return solution->identity.plot_style; }
};

/// Range of a logarithmic axis of differences in whole decades: from two decades below the smallest
/// maximum of a curve to the largest, at most eight decades.
std::pair<double, double> difference_decades(const FigureRanges& ranges);

/// Lower end of the logarithmic axis of a density: a power of ten below all values and at least a
/// decade below the upper end, but no lower than `floor`.
double logarithmic_bottom(const FigureRanges& ranges, double floor = kSmallestDrawnDensity);
/// Upper end of the logarithmic axis of a density: above the peak.
inline double logarithmic_top(const FigureRanges& ranges) { return 3 * ranges.largest_density; }

/// A note with the height of a spike that exceeds the linear panel; empty without such a spike.
std::string spike_note(const FigureRanges& ranges);

/// Ranges that contain all the curves. Pass only reliable curves: a single outlier would compress
/// all others.
FigureRanges figure_ranges(std::span<const DrawnCurve> curves);

}  // namespace fpkcheck::report
