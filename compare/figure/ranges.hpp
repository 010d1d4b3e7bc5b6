#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "compare/figure/curve_style.hpp"
#include "compare/marginals_csv.hpp"

namespace fpkcheck::compare {

/// The smallest density that the logarithmic panels show, as in the paper.
inline constexpr double kSmallestDrawnDensity = 1e-6;

/// Axis ranges of the panels of one variable.
struct FigureRanges {
  double linear_from, linear_to;            ///< where a density exceeds 1/500 of its peak
  double logarithmic_from, logarithmic_to;  ///< where a density exceeds kSmallestDrawnDensity
  double largest_density;
  double largest_difference;  ///< from the reference; 0 without one
};

/// A curve as it goes into a figure.
struct DrawnCurve {
  const nlohmann::ordered_json* solution;  ///< its element of "solutions" in summary.json
  CurveStyle style;
  const MarginalCurve* curve;
  std::vector<double> difference;  ///< from the reference curve, per bin; empty without one
};

/// Ranges that hold all the curves. Pass only those that are to be trusted with the scale: one wild
/// curve would press all others together.
FigureRanges figure_ranges(std::span<const DrawnCurve> curves);

}  // namespace fpkcheck::compare
