#pragma once

#include <span>
#include <vector>

#include "results/run.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::report {

/// The smallest density that the logarithmic panels show, as in the paper.
inline constexpr double kSmallestDrawnDensity = 1e-6;

/// Axis ranges of the panels of one variable.
struct FigureRanges {
  double linear_from, linear_to;            ///< where a density exceeds 1/500 of its peak
  double logarithmic_from, logarithmic_to;  ///< where a density exceeds kSmallestDrawnDensity
  double largest_density;
  double largest_difference;  ///< from the reference; 0 without one
};

/// A curve as it goes into a figure; it looks as its solution's identity says.
struct DrawnCurve {
  const transform::Solution* solution;
  const results::Curve* curve;
  std::vector<double> difference;  ///< from the reference curve, per bin; empty without one

  const transform::Look& look() const { return solution->identity.look; }
};

/// Ranges that hold all the curves. Pass only those that are to be trusted with the scale: one wild
/// curve would press all others together.
FigureRanges figure_ranges(std::span<const DrawnCurve> curves);

}  // namespace fpkcheck::report
