#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "results/run.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::report {

/// The smallest density that the logarithmic panels show, as in the paper.
inline constexpr double kSmallestDrawnDensity = 1e-6;

/// Axis ranges of the panels of one variable.
struct FigureRanges {
  double linear_from, linear_to;            ///< where a density exceeds 1/500 of linear_top
  double logarithmic_from, logarithmic_to;  ///< where a density exceeds kSmallestDrawnDensity
  double linear_top;          ///< the largest density but for the narrow bins that hold a spike
  double largest_density;     ///< in all bins
  double least_density;       ///< in all bins; 0 where one is empty
  double largest_difference;  ///< from the reference, but for narrow bins; 0 without one
  double least_difference;    ///< the smallest peak of a curve of differences
};

/// A curve less that of the reference. In smooth bins the size of it, and of the reference itself
/// half the width of its 95 % intervals: what it cannot tell from 0.
struct Difference {
  std::vector<double> abscissa, values;
  std::vector<double> lower, upper;  ///< ends of 95 % intervals; empty without

  bool empty() const { return values.empty(); }
};

/// A curve as it goes into a figure; it looks as its solution's identity says.
struct DrawnCurve {
  const transform::Solution* solution;
  const results::Curve* curve;
  Difference difference;  ///< from the reference's; empty without one

  /// Which of its bins are not the narrow ones into which those at a spike are divided
  /// (compare::comparison_axes): whatever they hold would press the rest to the axis.
  std::vector<bool> broad_bins() const;

  const transform::Look& look() const { return solution->identity.look; }
};

/// Of a logarithmic axis of differences: from two decades below the smallest peak up to the largest,
/// eight decades at most.
std::pair<double, double> difference_decades(const FigureRanges& ranges);

/// The logarithmic axis of a density begins at a power of ten below all of it, and a decade below its
/// own top at the least; no lower than `floor`.
double logarithmic_bottom(const FigureRanges& ranges, double floor = kSmallestDrawnDensity);
/// And it ends above the peak.
inline double logarithmic_top(const FigureRanges& ranges) { return 3 * ranges.largest_density; }

/// What to say where a spike goes beyond the linear panel; else empty.
std::string beyond_the_top(const FigureRanges& ranges);

/// Ranges that hold all the curves. Pass only those that are to be trusted with the scale: one wild
/// curve would press all others together.
FigureRanges figure_ranges(std::span<const DrawnCurve> curves);

}  // namespace fpkcheck::report
