#pragma once

#include <vector>

#include "problem/problem.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::compare {

/// The bins in which the marginal densities of a problem are compared. The bins are uniform, but
/// the bins at 0 may be divided. Distances use the undivided bins: no error estimate holds for
/// features of a density that are narrower than an undivided bin.
struct ComparisonAxes {
  /// Edges of the bins of y, increasing. In the paper's problems the first edge is the wall, y = 0.
  std::vector<double> y_edges;
  std::vector<double> v_edges;  ///< edges of the bins of y', increasing, symmetric about the edge 0
  /// Number of inner edges that divide the first bin of y and each of the two bins of y' at 0.
  int divisions = 0;
};

/// The comparison bins of a problem: uniform bins over 0 <= y <= y_s + 7 sigma_1 and
/// |y'| <= 7 sigma_2. sigma_1 and sigma_2 are the standard deviations of equivalent linearisation;
/// y_s is the static deflection under the mean of the impulses (0 in the paper). If the marginal
/// densities are unbounded at rest (problem::impulses_per_decay_time below 1), the bins next to 0
/// are divided at 1/4, 1/16 and 1/64 of their width, so that each part contains some of the mass.
/// For oscillators other than the paper's, the outermost edges are the limits of problem::scales,
/// and no bin is divided.
/// The bins depend on the problem alone. Hence a simulation can use the same bins for its
/// histogram, and the histogram needs no interpolation.
ComparisonAxes comparison_axes(const problem::Problem& problem);

/// The edges of the comparison bins of a variable.
const std::vector<double>& bin_edges(const ComparisonAxes& axes, transform::Variable variable);

/// The same axes without the inner edges that divide the bins at 0.
ComparisonAxes uniform_axes(const ComparisonAxes& axes);

/// Merges the parts of each divided bin of a marginal into one undivided bin with the same mass.
/// The confidence interval of a merged bin assumes independent errors of the parts.
/// @param marginal averages over the bins of `axes`
transform::Marginal merge_divided_bins(const ComparisonAxes& axes, transform::Variable variable,
                                       const transform::Marginal& marginal);

}  // namespace fpkcheck::compare
