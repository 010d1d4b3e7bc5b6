#pragma once

#include <vector>

#include "problem/problem.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::compare {

/// The bins over which marginal densities are averaged before their comparison. All comparison bins
/// have equal widths, but the bins at 0 may be divided into narrower bins. Distances between
/// densities are computed over undivided bins, since no error estimate holds for features of a
/// density narrower than a bin.
struct ComparisonBins {
  /// Increasing edges of the bins of y, which begin at the wall y = 0 for the paper's oscillator.
  std::vector<double> y_edges;
  std::vector<double> v_edges;  ///< increasing edges of the bins of y', symmetric about the edge 0
  /// Number of dividing edges within the first bin of y and within each of the two bins of y' at 0.
  int divisions = 0;
};

/// Returns the comparison bins of a problem: uniform bins over 0 <= y <= y_s + 7 sigma_1 and |y'|
/// <= 7 sigma_2, with standard deviations sigma_1 of y and sigma_2 of y'. The standard deviations
/// sigma_1 and sigma_2 come from equivalent linearisation, and y_s is the static deflection under
/// the mean of the impulses. If the marginal densities are unbounded at rest (few impulses per
/// decay time), the bins at 0 are divided at 1/4, 1/16 and 1/64 of their width, to resolve the peak
/// at rest. For oscillators other than the paper's, the outermost bin edges are the ends of the
/// motion in problem::motion_scales(), and no bin is divided. Since the comparison bins depend only
/// on the problem, a simulation can use these bins for its histogram.
ComparisonBins comparison_bins(const problem::Problem& problem);

const std::vector<double>& comparison_bin_edges(const ComparisonBins& axes,
                                                transform::StateVariable variable);

ComparisonBins undivided_comparison_bins(const ComparisonBins& axes);

/// Merges the parts of each divided bin of a marginal density into one undivided bin with the same
/// mass. The confidence interval of a merged bin assumes independent errors of the merged parts.
/// @param marginal averages over the bins of `axes`
transform::Marginal merge_divided_bins(const ComparisonBins& axes,
                                       transform::StateVariable variable,
                                       const transform::Marginal& marginal);

}  // namespace fpkcheck::compare
